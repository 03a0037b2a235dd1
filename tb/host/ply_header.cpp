#include "tb/host/ply_header.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include "tb/host/input_error.hpp"

namespace relievo::tb {

std::size_t size_of(ply_number t) {
  switch (t) {
    case ply_number::i8:
    case ply_number::u8:
      return 1;
    case ply_number::i16:
    case ply_number::u16:
      return 2;
    case ply_number::f64:
      return 8;
    default:
      return 4;
  }
}

namespace {

class header_reader {
 public:
  header_reader(std::string_view& bytes, std::string const& name) : rest_(bytes), name_(name) {}

  ply_header read() {
    if (rest_.substr(0, 3) != "ply" || words_of(header_line()) != std::vector<std::string>{"ply"})
      fail("no .ply file, the first line has to be 'ply'");
    ply_header header;
    bool have_format = false;
    while (true) {
      const std::string line = header_line();
      const std::vector<std::string> words = words_of(line);
      if (words.empty()) continue;
      if (words[0] == "end_header") break;
      if (words[0] == "comment" || words[0] == "obj_info") {
        const std::size_t text = line.find_first_not_of(" \t", line.find(words[0]) + words[0].size());
        if (words[0] == "comment") header.comments.push_back(text == std::string::npos ? "" : line.substr(text));
      } else if (words[0] == "format" && words.size() == 3) {
        if (words[1] == "ascii") {
          header.encoding = ply_encoding::text;
        } else if (words[1] == "binary_little_endian") {
          header.encoding = ply_encoding::little;
        } else if (words[1] == "binary_big_endian") {
          header.encoding = ply_encoding::big;
        } else {
          fail("format '" + words[1].substr(0, 40) + "' is none of ascii, binary_little_endian, binary_big_endian");
        }
        have_format = true;
      } else if (words[0] == "element" && words.size() == 3) {
        ply_element e;
        e.name = words[1];
        const auto [end, failed] = std::from_chars(words[2].data(), words[2].data() + words[2].size(), e.count);
        if (failed != std::errc() || *end != '\0' || e.count > 0xffffffffu)
          fail("element " + e.name.substr(0, 40) + ": '" + words[2].substr(0, 40) + "' is no count");
        header.elements.push_back(e);
      } else if (words[0] == "property" && !header.elements.empty() && words.size() == 3) {
        header.elements.back().properties.push_back({words[2], type_named(words[1]), false, ply_number::u8});
      } else if (words[0] == "property" && !header.elements.empty() && words.size() == 5 && words[1] == "list") {
        header.elements.back().properties.push_back({words[4], type_named(words[3]), true, type_named(words[2])});
      } else {
        fail("line '" + line.substr(0, 60) + "' is not understood");
      }
    }
    if (!have_format) fail("no format line");
    return header;
  }

 private:
  [[noreturn]] void fail(std::string const& why) const { throw input_error(name_ + ": header: " + why); }

  std::string header_line() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) fail("ends before end_header");
    std::string line(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
  }

  static std::vector<std::string> words_of(std::string const& line) {
    std::vector<std::string> words;
    std::size_t from = 0;
    while ((from = line.find_first_not_of(" \t", from)) != std::string::npos) {
      const std::size_t to = std::min(line.find_first_of(" \t", from), line.size());
      words.push_back(line.substr(from, to - from));
      from = to;
    }
    return words;
  }

  ply_number type_named(std::string const& word) const {
    static const std::map<std::string, ply_number> types = {
        {"char", ply_number::i8},   {"int8", ply_number::i8},     {"uchar", ply_number::u8},   {"uint8", ply_number::u8},
        {"short", ply_number::i16}, {"int16", ply_number::i16},   {"ushort", ply_number::u16}, {"uint16", ply_number::u16},
        {"int", ply_number::i32},   {"int32", ply_number::i32},   {"uint", ply_number::u32},   {"uint32", ply_number::u32},
        {"float", ply_number::f32}, {"float32", ply_number::f32}, {"double", ply_number::f64}, {"float64", ply_number::f64}};
    const auto found = types.find(word);
    if (found == types.end()) fail("unknown number type '" + word.substr(0, 40) + "'");
    return found->second;
  }

  std::string_view& rest_;
  std::string const& name_;
};

}  // namespace

ply_header read_ply_header(std::string_view& bytes, std::string const& name) { return header_reader(bytes, name).read(); }

}  // namespace relievo::tb
