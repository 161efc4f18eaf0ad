// A TOML text as cmake/pack_table.py packs it into the program: read where it lies, as a tree of values, at no cost for
// what is not asked for.
//
// A value is a letter for its kind, the size of its content in four bytes, low byte first, and the content: of a text
// its bytes, of a number the eight bytes of a double, low byte first, of a boolean one byte, of an array its values, of
// a table a byte for the length of each key, the key, and its value.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace plumbline::nc {

class PackedValue {
 public:
  enum class Kind : char { text = 't', number = 'n', boolean = 'b', array = 'a', table = 'o' };

  /// `bytes` begin with the value, and must outlive this.
  explicit PackedValue(std::string_view bytes) : bytes_(bytes) {}

  Kind kind() const { return static_cast<Kind>(bytes_.front()); }
  std::string_view content() const { return bytes_.substr(kHead, low_first(bytes_.substr(1, kHead - 1))); }
  /// Of a text.
  std::string_view text() const { return content(); }
  /// Of a number, whole ones too.
  double number() const { return std::bit_cast<double>(low_first(content())); }
  /// Of a boolean.
  bool flag() const { return content().front() != '\0'; }

  /// The value of that key of a table, or nothing.
  std::optional<PackedValue> find(std::string_view key) const {
    std::optional<PackedValue> found;
    each_entry([&](std::string_view its_key, const PackedValue& value) {
      if (its_key == key) found = value;
    });
    return found;
  }

  /// Calls take(key, value) for each of a table, in the order of the text.
  template <class Take>
  void each_entry(Take&& take) const {
    for (std::string_view rest = content(); !rest.empty();) {
      const std::size_t length = static_cast<unsigned char>(rest.front());
      const PackedValue value(rest.substr(1 + length));
      take(rest.substr(1, length), value);
      rest.remove_prefix(1 + length + value.size());
    }
  }

  /// The values of an array, one after the other.
  class Items {
   public:
    explicit Items(std::string_view rest) : rest_(rest) {}
    class Iterator {
     public:
      explicit Iterator(std::string_view rest) : rest_(rest) {}
      PackedValue operator*() const { return PackedValue(rest_); }
      Iterator& operator++() {
        rest_.remove_prefix(PackedValue(rest_).size());
        return *this;
      }
      bool operator!=(const Iterator& other) const { return rest_.size() != other.rest_.size(); }

     private:
      std::string_view rest_;
    };
    Iterator begin() const { return Iterator(rest_); }
    static Iterator end() { return Iterator({}); }

   private:
    std::string_view rest_;
  };
  Items items() const { return Items(content()); }

 private:
  static constexpr std::size_t kHead = 5;

  static std::uint64_t low_first(std::string_view bytes) {
    std::uint64_t number = 0;
    for (std::size_t i = bytes.size(); i > 0; --i) number = number << 8U | static_cast<unsigned char>(bytes[i - 1]);
    return number;
  }
  std::size_t size() const { return kHead + content().size(); }

  std::string_view bytes_;
};

}  // namespace plumbline::nc
