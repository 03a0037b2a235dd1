#include "tb/commands/told_difference.hpp"

#include <cinttypes>
#include <cstdio>

#include "tb/cosim/engine_bench.hpp"

namespace relievo::tb {

namespace {

// As a shell takes it as one word.
std::string quoted(std::string const& word) {
  if (!word.empty() &&
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+./,:@%") == std::string::npos)
    return word;
  std::string text = "'";
  for (char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

bool known_in(scene const& sc, double index) { return index >= 0 && index < static_cast<double>(sc.triangles.size()); }

// A circuit that breaks a rule of its links on this triangle alone is wrong on it too.
bool differs_alone(scene const& one, std::function<comparison(scene const&)> const& run_again) {
  try {
    return run_again(one).first.has_value();
  } catch (cosim_error const&) {
    return true;
  }
}

nlohmann::json to_json(found_difference const& d) {
  nlohmann::json json = {{"unit", d.unit}, {"base_triangle", d.triangle.index}, {"words_different", d.words_different}};
  if (d.has_path) json["path"] = path_text(d.path);
  if (!d.at) {
    json["only_in"] = d.names[d.side];
    return json;
  }
  json["field"] = d.at->name;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::uint64_t mask = d.at->width == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << d.at->width) - 1;
    char text[20];
    std::snprintf(text, sizeof text, "0x%0*" PRIx64, (d.at->width + 3) / 4, static_cast<std::uint64_t>(d.words[i]) & mask);
    json["words"][d.names[i]] = {{"raw", text}, {"value", d.at->value(d.words[i])}};
  }
  return json;
}

}  // namespace

std::string command_text(CLI::App const& app, std::string const& more) {
  std::string text = (app.get_parent() != nullptr ? quoted(app.get_parent()->get_name()) + " " : "") + app.get_name();
  for (CLI::Option const* o : app.get_options()) {
    if (o->count() == 0 || o->get_group() == "Output") continue;
    const std::string name = o->get_positional() ? "" : o->get_name();
    if (o->get_items_expected() == 0) {
      text += " " + name;
      continue;
    }
    for (std::string const& value : o->results()) {
      // What begins with a minus would be taken for an option.
      if (name.empty())
        text += " " + quoted(value);
      else
        text += " " + name + (value.rfind('-', 0) == 0 ? "=" : " ") + quoted(value);
    }
  }
  return text + more;
}

told told_difference(comparison const& c, scene const& sc, CLI::App const& app, std::string const& only,
                     std::function<comparison(scene const&)> const& run_again) {
  told result;
  if (!c.first) {
    result.text = "first difference: " + c.first_difference + "\n";
    return result;
  }
  found_difference d = *c.first;
  std::string replay = command_text(app, ""), why;
  if (sc.options.base_triangle || known_in(sc, d.triangle.index)) {
    const int index = static_cast<int>(d.triangle.index);
    const scene one = sc.options.base_triangle ? sc : only_base_triangle(sc, index);
    if (d.has_path) d.path = path_in(run_model("golden", one), d.triangle).value_or(d.path);
    if (!sc.options.base_triangle) {
      if (differs_alone(one, run_again))
        replay = command_text(app, " " + only + " " + std::to_string(index));
      else
        why = " (base triangle " + std::to_string(index) + " alone does not differ: it takes the others under way)";
    }
  }
  result.text = "first difference: " + to_text(d) + "\nreplay: " + replay + why + "\n";
  result.json = to_json(d);
  result.json["replay"] = replay;
  return result;
}

}  // namespace relievo::tb
