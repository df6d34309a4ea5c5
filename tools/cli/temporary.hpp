/// The temporary name of a file that is to replace another: it does not outlive the process.
///
/// While there is one, the signals that end a process (HUP, INT, QUIT, PIPE, TERM, XCPU, XFSZ) remove it
/// first, unless they are ignored or handled already. Only SIGKILL and a crash leave a name.
#pragma once

#include <string>

namespace asperity::cli {

class TemporaryName {
 public:
  /// The name is free to be given to a file from now on.
  explicit TemporaryName(std::string path);
  ~TemporaryName();  ///< removes the file, if it still has the name
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

  const char* path() const { return path_.c_str(); }
  /// The file takes the place of `target`; false, with errno, where it cannot.
  bool replace(const std::string& target);
  /// The name is somebody else's: it is left alone.
  void forget();

 private:
  std::string path_;
  bool known_ = true;
};

}  // namespace asperity::cli
