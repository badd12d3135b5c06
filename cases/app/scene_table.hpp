#pragma once
#include "cases/app/curve.hpp"
#include "cases/app/scene_words.hpp"
#include "core/quantity.hpp"
#include "core/vec.hpp"

#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace velum::cases {

/// What a value must be beside finite.
enum class Sign { any, not_negative, positive };

/// Where the keys of a scene were given: in its file or by --set.
struct Origins {
  std::string file;
  std::vector<std::string> overridden;        // keys given by --set
  std::map<std::string, std::string> places;  // of every key that was read
  int dimensions = 2;                         // coordinates of a point
  std::string whole = "the scene";            // what the file is
};

/// One table of a scene while it is read. Every function that reads a key notes its place, and
/// throws core::InputError with place, key, fault and what is allowed. A key without fallback is
/// required.
class SceneTable {
 public:
  SceneTable(toml::table const& table, std::string path, Origins& origins);

  std::string const& path() const { return path_; }
  bool has(std::string const& key) const;

  /// Refuses every key that is not in the list; `condition` says when the list holds.
  void allow(std::vector<std::string> const& keys, std::string const& condition = "") const;

  /// A value with its unit, in SI.
  double quantity(std::string const& key, core::Dimension dimension, Sign sign = Sign::any,
                  std::optional<double> fallback = {});
  /// The same, empty when the key is missing or "auto".
  std::optional<double> quantity_or_auto(std::string const& key, core::Dimension dimension);
  /// The same for a pressure per length, Pa/m.
  std::optional<double> pressure_per_length_or_auto(std::string const& key);
  /// A number without unit, > 0.
  double number(std::string const& key, double fallback);
  /// A number without unit of any sign.
  double any_number(std::string const& key);
  /// Numbers > 0, at least one.
  std::vector<double> numbers(std::string const& key);
  std::string text(std::string const& key);
  /// One of the words of a choice.
  template <class Choice>
  Choice choice(std::string const& key, std::optional<Choice> fallback = {});
  /// Different words of a list, in its order.
  std::vector<std::string> texts(std::string const& key, std::vector<std::string> const& words);
  /// Values with their units, in SI, positive, at least one.
  std::vector<double> quantities(std::string const& key, core::Dimension dimension);
  /// Says how many coordinates a point of the scene has; 2 until then.
  void set_dimensions(int dimensions) { origins_->dimensions = dimensions; }
  int dimensions() const { return origins_->dimensions; }
  /// A value of a dimension for each coordinate, in SI.
  Vec3 vector(std::string const& key, core::Dimension dimension);
  /// A length for each coordinate.
  Vec3 point(std::string const& key, std::optional<Vec3> fallback = {});
  /// Two lengths.
  Vec2 pair(std::string const& key);
  /// Name of a file in the folder of the scene; the results folder gets a copy, so that the scene
  /// as run can be run again from there.
  std::string file_name(std::string const& key);
  /// Where such a file is.
  std::filesystem::path beside(std::string const& name) const;
  /// Rows of two lengths.
  std::vector<Vec2> points(std::string const& key);
  /// A single value, or a table of rows [argument, value] with increasing arguments.
  Curve curve(std::string const& key, core::Dimension argument, core::Dimension value,
              Sign sign = Sign::any, std::optional<double> fallback = {});

  SceneTable table(std::string const& key);
  /// The tables inside this one, by name.
  std::vector<std::pair<std::string, SceneTable>> tables();
  /// An array of tables with at least one entry.
  std::vector<SceneTable> list(std::string const& key);

  [[noreturn]] void fail(std::string const& key, std::string const& what) const;

 private:
  std::string full(std::string const& key) const;
  std::string place(std::string const& path, toml::node const& node) const;
  [[noreturn]] void fail_at(toml::node const& node, std::string const& path,
                            std::string const& what) const;
  toml::node const* find(std::string const& key);
  toml::node const& require(std::string const& key, std::string const& what);
  double quantity_of(toml::node const& node, std::string const& path, core::Dimension dimension,
                     Sign sign) const;
  double number_of(toml::node const& node, std::string const& path) const;
  toml::array const& entries_of(std::string const& key, std::string const& wanted);
  toml::array const& row_of(std::size_t n, toml::node const& node, std::string const& path,
                            std::string const& what) const;
  Vec3 values_of(int n, toml::node const& node, std::string const& path,
                 core::Dimension dimension) const;
  std::string word_of(std::string const& key, std::vector<std::string> const& words, bool required);

  toml::table const* table_;
  std::string path_;
  Origins* origins_;
};

template <class Choice>
Choice SceneTable::choice(std::string const& key, std::optional<Choice> fallback)
{
  std::vector<std::string> names;
  for (auto const& [name, value] : words(Choice{})) names.push_back(name);
  std::string const given = word_of(key, names, !fallback);
  for (auto const& [name, value] : words(Choice{}))
    if (name == given) return value;
  return *fallback;
}

}  // namespace velum::cases
