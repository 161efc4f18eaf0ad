// What # names: numbered and named parameters of a program.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "nc/language/block.hpp"

namespace plumbline::nc {

inline constexpr int kLocalParameters = 30;   // #1..#30 belong to a subprogram
inline constexpr int kLastParameter = 5601;   // [LinuxCNC; RS274/NGC has 5400]
inline constexpr int kG92InForce = 5210;      // 1 where the six after it hold an offset
inline constexpr int kParametersPerRow = 20;  // from that of a work system or home to that of the next one
inline constexpr int kMostParameters = 9999;  // of any control

/// A number, or one that only the machine will know.
struct Value {
  double number = 0;
  bool known = true;
  bool vacant = false;     // of a variable that was never set, where the language has such; counts as 0
  bool rounded = false;    // worked out of numbers with more digits than a control keeps
  bool bracketed = false;  // vacant, in brackets: whether it still is was found in no source
  bool of_caller = false;  // a program that calls this one gives it, and none does
};

/// Whose #1..#30 a subprogram has.
enum class LocalNumbers : std::uint8_t { own, callers };

class Parameters {
 public:
  /// True if the program or its settings gave it a value. `number` is 1..kLastParameter.
  bool has(int number) const { return numbered(number).set; }
  Value get(int number) const { return numbered(number).value; }
  void set(int number, Value value);

  /// Names are the same whatever their case and blanks [RS274/NGC 3.3.1]. Null: never set.
  const Value* find(std::string_view name);
  void set(std::string_view name, Value value);
  /// What `name` keeps of the values that it is set to from now on, in the scope that is executed.
  void declare(std::string_view name, VariableType type);
  /// False if another place of the program that is executed declared the name before.
  bool declare_once(std::string_view name, std::uint64_t place);
  /// It was declared so: what it is set to is rounded.
  bool is_whole(std::string_view name);
  /// True if the program or subprogram that is executed set a name of its own.
  bool has_own_names() const { return !scopes_.back().names.empty(); }
  /// True if a subprogram that has ended, or a caller, set a name of its own that is called so.
  bool was_local_elsewhere(std::string_view name);
  /// For controls whose names are all those of the program that declares them, also the ones that begin with _.
  void keep_names_apart() { shares_names_ = false; }
  /// For controls of which no source says whether a program and its subprograms share their names: from now on it is
  /// noted what each was set to last.
  void watch_names() { watches_ = true; }
  /// True if the name, were it common to them, had another value than the one of the scope that is executed.
  bool depends_on_scope(std::string_view name);
  /// The subprogram that begins was handed this name: it ends with it.
  void note_argument(std::string_view name);
  /// A subprogram begins: the names that do not begin with _ are its own; so are #1..#30 if `numbers` says so (then all
  /// zero).
  void enter(LocalNumbers numbers);
  /// The same with #1..#`count`, which begin without a value.
  void enter_with_own(int count);
  /// A subprogram begins that shares all names and numbers with its caller.
  void enter_sharing();
  /// The block that called calls once more: what the subprogram left in names and numbers of its own, and what they are
  /// worth as it begins again, is known of those alone that are as they were when `remember_begin` was called.
  void remember_begin();
  void begin_again();
  bool is_left_over(int number) const { return numbered(number).left_over; }
  bool is_left_over(std::string_view name);
  /// The names that the subprogram set, and that are its own, have no value any more.
  void forget_own_names();
  /// It ends: those of its caller are back.
  void leave();
  /// How often one got another value.
  std::uint64_t changes() const { return changes_; }
  /// #1 and so on are those of the main program.
  bool numbers_are_of_main() const;
  /// Subprograms that are being executed.
  std::size_t depth() const { return scopes_.size() - 1; }
  /// The name as it is looked up; valid until the next call.
  std::string_view plain(std::string_view name);

 private:
  Value converted(Value value);  // of the name in plain_
  struct Numbered {
    Value value;
    bool set = false;
    bool left_over = false;  // of the call before, by the same block
  };
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
  };
  // Few of the thousands are ever set: those in a row come to be with the first of them.
  static constexpr std::size_t kRow = 128;
  static_assert(kLocalParameters < kRow);
  using Row = std::vector<Numbered>;
  const Numbered& numbered(int number) const {
    static constexpr Numbered kUnset;
    const auto at = static_cast<std::size_t>(number);
    const Row& row = numbered_[at / kRow];
    return row.empty() ? kUnset : row[at % kRow];
  }
  Numbered& numbered(int number) { return row_of(number)[static_cast<std::size_t>(number) % kRow]; }
  Row& row_of(int number) {
    Row& row = numbered_[static_cast<std::size_t>(number) / kRow];
    if (row.empty()) row.resize(kRow);
    return row;
  }
  Row::iterator locals() { return row_of(1).begin() + 1; }

  std::array<Row, kMostParameters / kRow + 1> numbered_;
  using Names = std::unordered_map<std::string, Value, Hash, std::equal_to<>>;
  struct Scope {
    Names names;
    std::unordered_map<std::string, VariableType, Hash, std::equal_to<>> types;      // of those that are not real
    std::unordered_map<std::string, std::uint64_t, Hash, std::equal_to<>> declared;  // where
    std::vector<Numbered> callers;                                                   // #1..#30 of the caller
    std::vector<Numbered> first;                                                     // its own, as it began
    Names first_names;
    std::set<std::string, std::less<>> left_over;  // names
    bool shared = false;                           // the names are those of the caller
  };
  /// Whose names those of the scope that is executed are.
  Scope& owner() {
    std::size_t at = scopes_.size() - 1;
    while (scopes_[at].shared) --at;
    return scopes_[at];
  }
  Names& scope_of(std::string_view plain) { return shares_names_ && plain.starts_with('_') ? global_ : owner().names; }
  Names global_;
  bool shares_names_ = true;  // those that begin with _
  std::vector<Scope> scopes_{Scope{}};
  std::set<std::string, std::less<>> left_;  // names of subprograms that have ended
  std::uint64_t changes_ = 0;
  std::string plain_;
  struct LastSet {
    Value value;
    std::size_t argument_of = 0;  // depth of the call that handed it over; 0: none
    bool ended = false;           // that call has
  };
  std::unordered_map<std::string, LastSet, Hash, std::equal_to<>> last_set_;  // names that are watched
  bool watches_ = false;
};

}  // namespace plumbline::nc
