// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "source/text_file.hpp"

namespace rung {
namespace {

constexpr SourcePosition kWholeFile{1, 1};

// Writes all of `contents` to the open file; false, with errno, when that fails.
bool write_all(int descriptor, std::string_view contents) {
  while (!contents.empty()) {
    const ssize_t written = ::write(descriptor, contents.data(), contents.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return false;
    }
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// The mode that a plain create would have given, or that of the file to be replaced.
mode_t mode_for(const std::filesystem::path& target) {
  struct stat old {};
  if (::stat(target.c_str(), &old) == 0) return old.st_mode & 0777U;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666U & ~mask;
}

bool replace_file(const std::filesystem::path& target, std::string_view contents) {
  std::string temporary = target.string() + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary.data());
  if (descriptor < 0) return false;
  bool good = write_all(descriptor, contents) && ::fchmod(descriptor, mode_for(target)) == 0;
  int failure = errno;
  if (::close(descriptor) != 0 && good) {
    good = false;
    failure = errno;
  }
  if (good && ::rename(temporary.c_str(), target.c_str()) != 0) {
    good = false;
    failure = errno;
  }
  if (!good) {
    ::unlink(temporary.c_str());
    errno = failure;
  }
  return good;
}

}  // namespace

bool write_file(const std::string& path, std::string_view contents, Diagnostics& diagnostics) {
  const auto failed = [&] {
    diagnostics.error(path, kWholeFile, fmt::format("cannot write it: {}", std::strerror(errno)));
    return false;
  };
  if (path == "-") {
    std::cout.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    std::cout.flush();
    return std::cout.good() || failed();
  }
  // A link stays a link: its target is replaced.
  std::error_code ignored;
  const std::filesystem::path resolved = std::filesystem::weakly_canonical(path, ignored);
  const std::filesystem::path target = resolved.empty() ? std::filesystem::path(path) : resolved;
  const std::filesystem::file_status status = std::filesystem::status(target, ignored);
  if (std::filesystem::is_directory(status)) {
    diagnostics.error(path, kWholeFile, "cannot write it: this is a directory");
    return false;
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    std::ofstream direct(target, std::ios::binary);
    direct.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    direct.flush();
    return direct.good() || failed();
  }
  return replace_file(target, contents) || failed();
}

}  // namespace rung
