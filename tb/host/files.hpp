// files: whole files in and out. Every reader and writer of the host goes through these two.
//
//   read_bytes(path)          the file's bytes; input_error when it is missing, unreadable, no file, empty or above 4 GiB
//   write_bytes(path, bytes)  writes a temporary file beside `path` and renames it at the end, so that a partial file never
//                             stands under the final name; input_error when that cannot be done. A link keeps pointing where it
//                             points; what is no regular file (a device, a pipe) is written to as it is
//   check_writable(path)      input_error when write_bytes would certainly fail: to be asked before long work
#pragma once
#include <string>
#include <string_view>

namespace relievo::tb {

std::string read_bytes(std::string const& path);
void write_bytes(std::string const& path, std::string_view bytes);
void check_writable(std::string const& path);

// The part of `path` after its last dot, in lower case; empty when there is none.
std::string extension_of(std::string const& path);

}  // namespace relievo::tb
