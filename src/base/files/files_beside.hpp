// Which files beside a program are read because it calls them, for who has to know when it must be read again.
#pragma once

#include <string>
#include <vector>

namespace plumbline {

/// While one lives it is told of the files that are looked for on behalf of `program`, on whatever thread: deep inside,
/// where nobody knows who asks. One at a time of a program.
class FilesBeside {
 public:
  struct Sought {
    std::string name;  // by which the program calls it; empty: it is read because the program may
    std::string path;  // empty: there is none
    bool operator==(const Sought&) const = default;
  };

  /// `program` as its InputFile is called.
  explicit FilesBeside(std::string program);
  ~FilesBeside();
  FilesBeside(const FilesBeside&) = delete;
  FilesBeside& operator=(const FilesBeside&) = delete;

  /// Each of them once, in the order of their paths.
  std::vector<Sought> files() const;

  /// Tells the one of this program, if there is one.
  static void note(const std::string& program, const std::string& name, const std::string& path);

 private:
  std::string program_;
};

}  // namespace plumbline
