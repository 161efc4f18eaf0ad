// What the functions of plumbline.hpp take and give.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <plumbline/export.h>

namespace plumbline::api {
inline namespace v1 {

struct Inside;  // of the library

/// A place in a text: lines and columns count from 1, columns in bytes. line 0: the text as a whole, or none.
struct Place {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  std::size_t length = 0;  // bytes, from the column on, that are meant
  std::string text;        // the line itself, without its end
};

enum class Severity { error, warning, note };

struct Diagnostic {
  std::string code;     // stable and short: "nc-unknown-code"; explain() says what it means
  std::string message;  // one sentence, no full stop, what is wrong
  std::string help;     // the way out
  Place place;
  Severity severity = Severity::error;
};

/// All that the functions throw. what() is the diagnostic as the command prints it.
class PLUMBLINE_API Error : public std::exception {
 public:
  enum class Kind {
    refused,      // the input: nothing was written
    wrong_usage,  // the call: an option that there is not, a value that is none (code "usage-wrong")
    bug,          // of plumbline (code "internal-error"): please report it
  };
  Error(Kind kind, Diagnostic diagnostic);
  Error(const Error&) = default;
  Error(Error&&) = default;
  Error& operator=(const Error&) = default;
  Error& operator=(Error&&) = default;
  ~Error() override;

  const char* what() const noexcept override;
  Kind kind() const noexcept { return kind_; }
  const Diagnostic& diagnostic() const noexcept { return diagnostic_; }
  /// One JSON object on one line, as the command prints it with --diagnostics=json.
  std::string json() const;

 private:
  Kind kind_;
  Diagnostic diagnostic_;
  std::string what_;
};

/// What is read.
class Input {
 public:
  /// A file by its path.
  static Input file(std::string path) { return Input(std::move(path), nullptr); }
  /// A text in memory. Messages call it `name`; files that it refers to (subprograms) are looked for beside that name.
  static Input text(std::string text, std::string name = "<text>") {
    return Input(std::move(name), std::make_shared<const std::string>(std::move(text)));
  }

 private:
  friend struct Inside;
  Input(std::string name, std::shared_ptr<const std::string> text) : name_(std::move(name)), text_(std::move(text)) {}
  std::string name_;
  std::shared_ptr<const std::string> text_;
};

/// What is written, whole and at the end, or not at all.
class Output {
 public:
  using Taker = std::function<void(std::string_view bytes)>;

  static Output nothing() { return Output({}, {}); }
  /// A file, which appears under its name when it is whole; a file that stood there stays until then.
  static Output file(std::string path) { return Output(std::move(path), {}); }
  /// Replaces what `into` holds. It must outlive the call, as the stream below.
  static Output text(std::string& into) {
    return Output("<text>", [&into, begun = false](std::string_view bytes) mutable {
      if (!begun) into.clear();
      begun = true;
      into.append(bytes);
    });
  }
  /// Throws an Error of the code file-unwritable if the stream fails.
  PLUMBLINE_API static Output stream(std::ostream& into);
  /// Calls `take` with piece after piece; what it throws is passed on.
  static Output taken_by(Taker take) { return Output("<output>", std::move(take)); }

 private:
  friend struct Inside;
  Output(std::string name, Taker take) : name_(std::move(name)), take_(std::move(take)) {}
  std::string name_;
  Taker take_;
};

/// Options by their long names on the command line, with the texts that stand there: ("work-offset",
/// "G54=0,0,-1008,0,0,0"), mm and deg, ("undo", "on"). Which there are is said beside each function; a function throws
/// wrong_usage at any other.
class Options {
 public:
  struct Given {
    std::string name;
    std::string value;
    std::shared_ptr<const Input> input;  // in place of the value
  };
  /// Options that can be repeated add up; of others the last counts.
  Options& set(std::string name, std::string value = "on") {
    given_.push_back({std::move(name), std::move(value), nullptr});
    return *this;
  }
  /// "tools", "variables" and "poses" need be no files.
  Options& set(std::string name, Input input) {
    given_.push_back({std::move(name), {}, std::make_shared<const Input>(std::move(input))});
    return *this;
  }
  const std::vector<Given>& given() const { return given_; }

 private:
  std::vector<Given> given_;
};

/// A machine's model, read and checked. Copies share it, and threads may.
class PLUMBLINE_API Model {
 public:
  /// No model, where a function can do without.
  Model() = default;
  explicit Model(const Input& input);

  bool is_given() const { return impl_ != nullptr; }
  /// Of the machine; empty without a model, as the others.
  std::string name() const;
  /// Of its text: 16 hexadecimal digits, as compensated programs name it.
  std::string hash() const;
  std::string text() const;
  /// As messages call it; files that it refers to are looked for beside that.
  std::string file() const;

 private:
  friend struct Inside;
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// What a function found.
class PLUMBLINE_API Result {
 public:
  /// As JSON, what the command writes with --json [docs/formats.md].
  const std::string& json() const;
  /// As the command says it to people: lines.
  const std::string& words() const;
  const std::vector<Diagnostic>& warnings() const;
  /// Where the command ends with code 3: limits broken, programs that differ.
  bool found() const;
  /// A figure of json() by its path between slashes: "moves", "worst_residual_um/value", "runs/0/radial_rms_um". NaN if
  /// it is null. Throws wrong_usage if there is none, or it is no number.
  double number(std::string_view path) const;
  /// The model file that identify, calibrate, diagnose and new_model leave; empty of others. Throws refused, which says
  /// why, where something speaks against the model.
  const std::string& model() const;

 private:
  friend struct Inside;
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// A pose of the tool tip in the machine's base frame W: R = Rz(C) Ry(B) Rx(A), or as the model says.
struct Pose {
  double x_mm = 0, y_mm = 0, z_mm = 0;
  double a_deg = 0, b_deg = 0, c_deg = 0;
};

/// Numbers in named columns.
struct Table {
  std::vector<std::string> columns;  // their units at the end of their names: "dx_um"
  std::vector<double> values;        // row after row
  std::vector<Diagnostic> warnings;
  std::size_t rows() const { return columns.empty() ? 0 : values.size() / columns.size(); }
  double at(std::size_t row, std::size_t column) const { return values[row * columns.size() + column]; }
};

/// Called now and then with the work done and the whole of it. What it throws ends the work and is passed on; nothing
/// is written then.
using Progress = std::function<void(std::uint64_t done, std::uint64_t total)>;

}  // namespace v1
}  // namespace plumbline::api
