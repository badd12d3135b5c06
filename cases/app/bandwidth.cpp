#include "cases/app/bandwidth.hpp"

#include <Kokkos_Core.hpp>

#include "core/host_access.hpp"
#include "core/huge_pages.hpp"

namespace velum::cases {
namespace {

using Array = Kokkos::View<float*>;
constexpr double measured_seconds = 0.3;
constexpr std::size_t block = 4096;  // numbers that a thread takes at a time

Array make_array(std::size_t n)
{
  Array a(Kokkos::view_alloc(std::string("array"), Kokkos::WithoutInitializing), n);
  if constexpr (core::on_host) core::prefer_huge_pages(a.data(), n * sizeof(float));
  Kokkos::deep_copy(a, 1.0f);
  return a;
}

/// Repeats a sweep over blocks; bytes moved per second.
template <class Sweep>
double speed(std::size_t n, double bytes, Sweep const& sweep)
{
  auto const run = [&] {
    Kokkos::parallel_for("velum::cases::bandwidth", n / block, sweep);
    Kokkos::fence();
  };
  run();
  Kokkos::Timer clock;
  int runs = 0;
  for (; clock.seconds() < measured_seconds; ++runs) run();
  return runs * bytes / clock.seconds();
}

}  // namespace

Bandwidth measure_bandwidth(std::size_t bytes)
{
  std::size_t const n = std::max(bytes / (3 * sizeof(float)) / block, std::size_t(1)) * block;
  Array const a = make_array(n), b = make_array(n), c = make_array(n), all = make_array(3 * n);
  double const size = double(n) * sizeof(float);
  return {speed(
              3 * n, 6 * size,
              KOKKOS_LAMBDA(std::size_t k) {
                float* const x = &all(k * block);
                for (std::size_t i = 0; i < block; ++i) x[i] *= 0.999f;
              }),
          speed(
              n, 2 * size,
              KOKKOS_LAMBDA(std::size_t k) {
                float const* const x = &a(k * block);
                float* const y = &b(k * block);
                for (std::size_t i = 0; i < block; ++i) y[i] = 0.5f * x[i];
              }),
          speed(
              n, 3 * size, KOKKOS_LAMBDA(std::size_t k) {
                float const* const x = &a(k * block);
                float const* const y = &b(k * block);
                float* const z = &c(k * block);
                for (std::size_t i = 0; i < block; ++i) z[i] = x[i] + 0.5f * y[i];
              })};
}

namespace {

constexpr std::size_t vector = 16, row = 16 * vector, ahead = 128;
constexpr std::size_t padding = 144;  // no power of two: streams must not share lines of a cache

}  // namespace

Streams::Streams(int count, std::size_t bytes_of_each)
    : count_(static_cast<std::size_t>(count)),
      size_(std::max(bytes_of_each / sizeof(float) / row, std::size_t(1)) * row),
      stride_(size_ + padding),
      all_(make_array(count_ * stride_ + ahead))
{
}

double Streams::speed() const
{
  std::size_t const count = count_, stride = stride_;
  Array const all = all_;
  return cases::speed(
      size_ / row * block, 2 * double(count * size_) * sizeof(float), KOKKOS_LAMBDA(std::size_t r) {
        for (std::size_t x = r * row; x < (r + 1) * row; x += vector)
          for (std::size_t s = 0; s < count; ++s) {
            float* const p = &all(s * stride + x);
            __builtin_prefetch(p + ahead, 1, 3);
            for (std::size_t i = 0; i < vector; ++i) p[i] *= 0.999f;
          }
      });
}

}  // namespace velum::cases
