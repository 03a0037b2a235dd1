#include "tb/cosim/gtkwave_save.hpp"

#include <gtkwave/fstapi.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string_view>

#include "tb/host/input_error.hpp"

namespace relievo::tb {

namespace {

bool ends_with(std::string const& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// GTKWave's flags of a line: binary or hexadecimal, and the borders of a group, open or closed.
constexpr char const* binary = "@28\n";
constexpr char const* hexadecimal = "@22\n";
std::string group(std::string const& name, std::string const& lines, bool open) {
  return std::string(open ? "@800200\n-" : "@c00200\n-") + name + "\n" + lines + (open ? "@1000200\n-" : "@1401200\n-") + name + "\n";
}

std::string line(fst_signal const& s) { return (s.bits == 1 ? binary : hexadecimal) + s.full_name() + "\n"; }

using port_list = std::vector<fst_signal const*>;

// How the signals of a link end: into a unit, out of it, and between its parts.
struct link_names {
  std::string_view valid;
  char const *ready, *word, *more;
};
constexpr link_names kinds[] = {
    {"_valid_i", "_ready_o", "_i", "_mask_i"}, {"_valid_o", "_ready_i", "_o", "_mask_o"}, {"_valid", "_ready", "", "_data"}};

// The signals of one scope: its links, then what else goes in and out; empty without a link.
std::string lines_of(port_list const& ports) {
  std::vector<bool> shown(ports.size(), false);
  const auto show = [&](std::string const& name) -> std::string {
    for (std::size_t i = 0; i < ports.size(); ++i)
      if (ports[i]->name == name && !shown[i]) {
        shown[i] = true;
        return line(*ports[i]);
      }
    return "";
  };
  std::string links;
  for (fst_signal const* p : ports)
    for (link_names const& names : kinds)
      if (ends_with(p->name, names.valid)) {
        const std::string stem = p->name.substr(0, p->name.size() - names.valid.size());
        const std::string valid = show(p->name);
        links += group(stem, valid + show(stem + names.ready) + show(stem + names.word) + show(stem + names.more), true);
        break;
      }
  if (links.empty()) return "";
  std::string others;
  for (std::size_t i = 0; i < ports.size(); ++i) {
    std::string const& name = ports[i]->name;
    const bool constant = name == "clk_i" || name == "rst_ni" || name.rfind("regs_", 0) == 0;
    if (!shown[i] && !constant && (ends_with(name, "_i") || ends_with(name, "_o"))) others += line(*ports[i]);
  }
  return links + others;
}

}  // namespace

fst_contents read_fst(std::string const& file) {
  const std::unique_ptr<void, void (*)(void*)> reader(fstReaderOpen(file.c_str()), [](void* r) {
    if (r != nullptr) fstReaderClose(r);
  });
  if (!reader) throw input_error(file + ": is no FST file");
  fst_contents contents;
  contents.first = fstReaderGetStartTime(reader.get());
  contents.last = fstReaderGetEndTime(reader.get());
  std::string scope;
  while (fstHier const* h = fstReaderIterateHier(reader.get())) {
    if (h->htyp == FST_HT_SCOPE) {
      scope += (scope.empty() ? "" : ".") + std::string(h->u.scope.name);
    } else if (h->htyp == FST_HT_UPSCOPE) {
      scope.erase(std::min(scope.size(), scope.rfind('.')));
    } else if (h->htyp == FST_HT_VAR) {
      // "name [high:low]"
      const std::string name = h->u.var.name;
      const std::size_t space = name.find(' ');
      contents.signals.push_back(
          {scope, name.substr(0, space), space == std::string::npos ? "" : name.substr(space + 1), h->u.var.length, h->u.var.handle});
    }
  }
  return contents;
}

std::string gtkwave_save(std::string const& file) {
  const fst_contents contents = read_fst(file);
  std::string text = "[dumpfile] \"" + std::filesystem::absolute(file).string() + "\"\n[timestart] " + std::to_string(contents.first) +
                     "\n[size] 1600 900\n[sst_expanded] 1\n[sst_width] 300\n[signals_width] 320\n";
  std::vector<std::string> scopes;  // as they come, each once
  for (fst_signal const& s : contents.signals)
    if (std::find(scopes.begin(), scopes.end(), s.scope) == scopes.end()) scopes.push_back(s.scope);
  for (std::string const& scope : scopes) {
    // TOP holds the top's ports once more.
    const std::size_t dot = scope.find('.');
    if (dot == std::string::npos) continue;
    port_list ports;
    for (fst_signal const& s : contents.signals)
      if (s.scope == scope) ports.push_back(&s);
    const bool top = scope.find('.', dot + 1) == std::string::npos;
    if (top)
      for (char const* name : {"clk_i", "rst_ni"})
        for (fst_signal const* p : ports)
          if (p->name == name) text += line(*p);
    if (const std::string lines = lines_of(ports); !lines.empty()) text += group(scope.substr(dot + 1), lines, top);
  }
  return text;
}

}  // namespace relievo::tb
