#include "tb/host/files.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "tb/host/input_error.hpp"

namespace relievo::tb {

namespace {

constexpr std::uintmax_t max_file_size = std::uintmax_t(1) << 32;

std::string reason() { return errno != 0 ? std::strerror(errno) : "unknown reason"; }

std::string temporary_name(std::string const& target) { return target + ".part." + std::to_string(::getpid()); }

// Removes the temporary file unless it was renamed.
class temporary_file {
 public:
  explicit temporary_file(std::string const& target) : path_(temporary_name(target)) {}
  temporary_file(temporary_file const&) = delete;
  temporary_file& operator=(temporary_file const&) = delete;
  ~temporary_file() {
    if (!kept_) std::remove(path_.c_str());
  }
  std::string const& path() const { return path_; }
  void keep() { kept_ = true; }

 private:
  std::string path_;
  bool kept_ = false;
};

// The file that a link leads to, be it there or not, so that the link stays one.
std::string behind_links(std::string const& path) {
  std::filesystem::path at = path;
  std::error_code failed;
  constexpr int most = 40;
  for (int i = 0; i < most && std::filesystem::is_symlink(at, failed); ++i) {
    const std::filesystem::path next = std::filesystem::read_symlink(at, failed);
    if (failed) return path;
    at = next.is_absolute() ? next : at.parent_path() / next;
  }
  return at.string();
}

void write_and_flush(std::string const& shown, std::string const& path, std::string_view bytes) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (!file) throw input_error(shown + ": cannot be written: " + reason());
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.flush();
  if (!file) throw input_error(shown + ": cannot be written: " + reason());
}

}  // namespace

std::string read_bytes(std::string const& path) {
  std::error_code failed;
  const auto status = std::filesystem::status(path, failed);
  if (failed || status.type() == std::filesystem::file_type::not_found) throw input_error(path + ": no such file");
  if (status.type() == std::filesystem::file_type::directory) throw input_error(path + ": is a folder, a file is needed");
  if (status.type() == std::filesystem::file_type::regular) {
    const auto size = std::filesystem::file_size(path, failed);
    if (!failed && size == 0) throw input_error(path + ": the file is empty");
    if (!failed && size > max_file_size) throw input_error(path + ": the file is larger than 4 GiB");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw input_error(path + ": cannot be opened: " + reason());
  std::string bytes;
  char block[1 << 16];
  while (file.read(block, sizeof block) || file.gcount() > 0) {
    bytes.append(block, static_cast<std::size_t>(file.gcount()));
    if (bytes.size() > max_file_size) throw input_error(path + ": more than 4 GiB came out of it");
  }
  if (file.bad()) throw input_error(path + ": cannot be read: " + reason());
  if (bytes.empty()) throw input_error(path + ": the file is empty");
  return bytes;
}

void write_bytes(std::string const& path, std::string_view bytes) {
  check_writable(path);
  std::error_code failed;
  const auto status = std::filesystem::status(path, failed);
  const bool in_place = std::filesystem::exists(status) && status.type() != std::filesystem::file_type::regular;
  if (in_place) return write_and_flush(path, path, bytes);
  const std::string target = behind_links(path);
  temporary_file temporary(target);
  write_and_flush(path, temporary.path(), bytes);
  if (std::rename(temporary.path().c_str(), target.c_str()) != 0) throw input_error(path + ": cannot be written: " + reason());
  temporary.keep();
}

void check_writable(std::string const& path) {
  std::error_code failed;
  if (path.empty()) throw input_error("the output's file name is empty");
  const auto status = std::filesystem::status(path, failed);
  if (status.type() == std::filesystem::file_type::directory) throw input_error(path + ": is a folder, cannot be written as a file");
  const bool in_place = std::filesystem::exists(status) && status.type() != std::filesystem::file_type::regular;
  const std::filesystem::path folder = std::filesystem::path(behind_links(path)).parent_path();
  const std::string asked = in_place ? path : folder.empty() ? "." : folder.string();
  errno = 0;
  // Whoever may not list a folder may still write there.
  if (::access(asked.c_str(), in_place ? W_OK : W_OK | X_OK) != 0) throw input_error(path + ": cannot be written: " + reason());
  if (!in_place && !std::filesystem::is_directory(asked, failed)) throw input_error(path + ": cannot be written: no such folder");
  if (in_place) return;
  // Names that the file system does not take show up here.
  const bool there = std::filesystem::exists(std::filesystem::symlink_status(temporary_name(behind_links(path)), failed));
  if (!there && failed && failed != std::errc::no_such_file_or_directory)
    throw input_error(path + ": cannot be written: " + failed.message());
}

std::string extension_of(std::string const& path) {
  const auto dot = path.rfind('.');
  const auto slash = path.rfind('/');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  std::string extension = path.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return extension;
}

}  // namespace relievo::tb
