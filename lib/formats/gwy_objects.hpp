/// The serialised objects that a .gwy file is made of.
///
/// An object is its class's name, NUL, the size of its body in four bytes, and the body: components, each a
/// name, NUL, a letter for its type, and a value:
///
///     b, c         a truth value, a character: one byte; C: several characters
///     i, q, d      a whole number of 32 or 64 bits, a double; I, Q, D: several
///     s, S         a string that ends with NUL; several
///     o, O         an object; several
///
/// Several values follow their number, in four bytes. All numbers are least significant byte first. Nothing
/// is copied: a component is a view of the file, and the objects in it are views of their bodies.
#pragma once

#include <optional>
#include <string_view>

namespace asperity {

struct GwyComponent {
  std::string_view name = {};
  char type = 0;
  std::string_view kind = {};  ///< an object's class
  std::string_view value =
      {};  ///< bytes of the number or numbers; a string without its NUL; an object's body
};

/// The components of an object, one after the other.
class GwyComponents {
 public:
  explicit GwyComponents(std::string_view body) : rest_(body) {}
  /// Nothing at the end. Throws DataError("map", …) where the body is cut short or of an unknown type.
  std::optional<GwyComponent> next();

 private:
  std::string_view rest_;
};

/// An object at the beginning of `bytes`, removed from them: its class and its body.
GwyComponent take_gwy_object(std::string_view& bytes);

}  // namespace asperity
