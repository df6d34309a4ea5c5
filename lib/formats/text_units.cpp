#include <algorithm>
#include <utility>

#include "formats/refuse.hpp"
#include "formats/text_head.hpp"

namespace asperity {
namespace {

constexpr std::string_view separators = ":=;,\t";

template <class Stems>
bool has_stem(std::string_view word, const Stems& stems) {
  return std::ranges::any_of(stems, [&](std::string_view stem) { return word.find(stem) != word.npos; });
}

struct Word {
  std::string_view text;
  char before;  // a separator, a blank, or '\n' at the beginning of the line
  bool brackets;

  bool number() const { return !brackets && begins_like_number(text); }
  bool separated() const { return separators.find(before) != separators.npos; }
};

// Where a word ends: a comma between digits is part of it.
std::size_t end_of_word(std::string_view line) {
  const auto digit = [&](std::size_t i) { return i < line.size() && line[i] >= '0' && line[i] <= '9'; };
  std::size_t end = 0;
  do end = std::min(line.find_first_of(" \"[(:=;,\t", end + 1), line.size());
  while (end < line.size() && line[end] == ',' && digit(end - 1) && digit(end + 1));
  return end;
}

// Brackets are one word, with what they contain.
std::vector<Word> words_in(std::string_view line) {
  std::vector<Word> out;
  for (char before = '\n'; !line.empty();) {
    const bool separator = separators.find(line[0]) != separators.npos;
    if (separator || line[0] == ' ' || line[0] == '"') {
      if (separator) before = line[0];
      line.remove_prefix(1);
      continue;
    }
    const bool brackets = line[0] == '[' || line[0] == '(';
    const std::size_t close = brackets ? line.find(line[0] == '[' ? ']' : ')') : line.npos;
    const std::size_t end = close == line.npos ? end_of_word(line) : close + 1;
    std::string_view text = line.substr(0, end);
    if (text.size() > 1 && text.ends_with('.')) text.remove_suffix(1);
    out.push_back({text, before, close != line.npos});
    before = ' ';
    line.remove_prefix(end);
  }
  return out;
}

// A unit of length, also in capitals and in German; "" for other words.
std::string length_in(std::string_view word) {
  constexpr std::size_t longest_symbol = 4, longest = 16;
  if (word.size() > longest) return "";
  if (is_length(word)) return std::string(word);
  const bool capitals = word == "NM" || word == "UM" || word == "MM";
  std::string name = capitals || word.size() > longest_symbol ? lower(word) : "";
  if (name.starts_with("mikro")) name[2] = 'c';
  return is_length(name) ? name : "";
}

// UDUNITS has lengths named point, link and in.
bool is_metric(std::string_view unit) {
  constexpr std::string_view names[] = {"met", "micron", "ngstr", "\u00c5", "\u212b"};
  return unit.ends_with('m') || has_stem(unit, names);
}

// "[nm]", "(-> m)", "(in nm)".
std::string unit_in_brackets(std::string_view text) {
  const bool square = text[0] == '[';
  text = text.substr(1, text.size() - 2);
  for (const std::string_view word : {"->", "in "})
    if (const std::size_t at = text.find(word); at != text.npos) text.remove_prefix(at + word.size());
  text = trimmed(text);
  const std::string length = length_in(text);
  return length.empty() && square && is_unit(text) ? std::string(text) : length;
}

// Whose a unit or a number is, by the words before it.
struct Subject {
  bool z = false, height = false, lateral = false, other = false, unit = false, factor = false;

  Subject() = default;
  explicit Subject(std::string_view words) { add(words); }

  void add(std::string_view words) {
    const std::string name = lower(words);
    if (name.find("bit2") != name.npos) return static_cast<void>(factor = true);
    for (auto from = std::ranges::find_if(name, is_alpha); from != name.end();) {
      const auto end = std::find_if_not(from, name.end(), is_alpha);
      add_part(std::string(from, end));
      from = std::find_if(end, name.end(), is_alpha);
    }
  }

  bool empty() const { return !(z || height || lateral || other || unit || factor); }
  bool known() const { return !empty() && !other; }
  bool of_values() const { return z || (!lateral && (height || !other)); }
  bool of_coordinates() const { return lateral && !z && !height; }

 private:
  // Whether a word had one of these in it.
  static bool taken(std::string& part, std::initializer_list<std::string_view> stems) {
    for (const std::string_view stem : stems)
      if (const std::size_t at = part.find(stem); at != part.npos) {
        part.erase(at, stem.size());
        return true;
      }
    return false;
  }

  void add_part(std::string part) {
    constexpr std::string_view values[] = {"value", "wert",  "data",     "daten", "depth",
                                           "tiefe", "image", "vertical", "rau",   "rough"},
                               along[] = {"width", "breite",  "pixel",      "size",     "spacing",
                                          "step",  "schritt", "horizontal", "sampling", "resolution"};
    unit |= taken(part, {"units", "unit", "einheiten", "einheit"});
    factor |= taken(part, {"conversion", "factor", "faktor", "scale", "scaling", "multiplier", "skalierung"});
    if (part.empty() || part == "in") return;
    const CoordinateRole role = role_of(part);
    if (part.find_first_not_of("xyz") == part.npos)
      (part.find('z') != part.npos ? z : lateral) = true;
    else if (role == CoordinateRole::x || has_stem(part, along))
      lateral = true;
    else
      (role == CoordinateRole::z || has_stem(part, values) ? height : other) = true;
  }
};

// What lines state of the unit of the values.
class UnitReader {
 public:
  void read(const HeadLine& line) {
    const std::string_view text =
        line.text.substr(std::min(line.text.find_first_not_of("#%;\\ \t"), line.text.size()));
    line_ = line.number;
    some_ = false;
    read_words(words_in(text));
    if (!some_) read_key(text);
  }

  std::string settled(const std::string& known, bool told) const {
    const std::string& unit = known.empty() ? unit_ : known;
    const bool differ = !unit_.empty() && !(same_length(unit, unit_) && same_length(unit, last_));
    if (told && (differ || scaled_ > 0)) return "";
    if (scaled_ > 0)
      refuse("line {}: a factor of the values: give their unit, which contains it (`unit` '2.5e-9 m')",
             scaled_);
    if (differ)
      refuse(
          "its head gives the values the unit {} and the unit {}: remove one of the lines, or give the right "
          "one (`unit`)",
          quoted(unit), quoted(same_length(unit, unit_) ? last_ : unit_));
    if (unit.empty() && !told && unclear_line_ > 0)
      refuse("line {}: {} may be the unit of the values: give it (`unit`), or the right one", unclear_line_,
             quoted(unclear_));
    return unit;
  }

 private:
  void read_words(const std::vector<Word>& words) {
    Subject last, subject;
    bool quantity = false, unit_before = false;  // quantity: the word before is the number of one
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i].number()) {
        if ((subject.factor || multiple(words, i)) && subject.of_values() && number_of(words[i].text) != 1.0)
          scaled_ = line_;
        quantity = words[i].separated() || unit_before;
        if (quantity) subject = {};
        unit_before = false;
        continue;
      }
      const std::string unit = unit_at(words, i, subject);
      const bool next = i + 1 < words.size(), taken = quantity || (next && words[i + 1].text == "per");
      unit_before = !unit.empty() && !quantity && next && words[i + 1].number();
      if (unit.empty()) {
        subject.add(words[i].text);
      } else if (!taken && !unit_before) {
        state(subject.empty() ? last : subject, unit);
        last = std::exchange(subject, {});
      }
      quantity = false;
    }
  }

  // "in 1e-9 m".
  static bool multiple(const std::vector<Word>& words, std::size_t i) {
    return i > 0 && i + 1 < words.size() && lower(words[i - 1].text) == "in" &&
           !length_in(words[i + 1].text).empty();
  }

  // The unit that a word is, or has after a name, which the subject gets.
  static std::string unit_at(const std::vector<Word>& words, std::size_t i, Subject& subject) {
    const auto& [text, before, brackets] = words[i];
    if (brackets) return unit_in_brackets(text);
    const Label label = label_of(text);
    if (!label.unit.empty() && Subject(label.name).known()) {
      subject.add(label.name);
      return label.unit;
    }
    const std::string former = i > 0 ? lower(words[i - 1].text) : "";
    const bool last = i + 1 == words.size() || words[i + 1].before != ' ' || words[i + 1].brackets;
    const bool after_in = before == ' ' && former == "in";
    const bool prompted = last && (before != ' ' || former == "of" || Subject(former).known());
    const std::string length = after_in || prompted ? length_in(text) : "";
    return after_in || is_metric(length) ? length : "";
  }

  // "Units: counts".
  void read_key(std::string_view text) {
    const std::size_t end = text.find_first_of(separators);
    if (end == text.npos) return;
    const Subject key(text.substr(0, end));
    const std::string_view value = text.substr(end + 1),
                           unit = trimmed(value.substr(0, value.find_first_of(";,\t")));
    if (key.unit && key.of_values() && !unit.empty()) state(key, std::string(unit));
  }

  void state(const Subject& subject, const std::string& unit) {
    some_ = true;
    if (subject.of_coordinates()) return;
    if (!subject.of_values()) {
      unclear_line_ = line_;
      unclear_ = unit;
    } else if (unit_.empty()) {
      unit_ = last_ = unit;
    } else if (same_length(unit_, last_)) {
      last_ = unit;
    }
  }

  std::size_t line_ = 0, unclear_line_ = 0, scaled_ = 0;
  bool some_ = false;  // the line has a unit
  std::string unit_, last_, unclear_;
};

}  // namespace

bool is_letter(const std::string& name) {
  return !name.empty() && is_alpha(name[0]) && (name.size() == 1 || !is_alpha(name[1]));
}

CoordinateRole role_of(const std::string& name) {
  using enum CoordinateRole;
  constexpr std::string_view along[] = {"position", "distance", "lateral", "abstand", "strecke"},
                             up[] = {"height", "h\u00f6he", "h\xf6he",   "hoehe",
                                     "profil", "altitude",  "topograph", "elevation"},
                             neither[] = {"length", "width",      "number", "count",
                                          "filter", "l\u00e4nge", "breite"};
  const std::string word = lower(name);
  if (is_letter(word)) return word[0] == 'x' ? x : word[0] == 'y' ? y : word[0] == 'z' ? z : other;
  const bool is_x = has_stem(word, along), is_z = has_stem(word, up);
  if (is_x == is_z || has_stem(word, neither)) return other;
  return is_x ? x : z;
}

bool names_coordinates(std::string_view name) { return Subject(name).of_coordinates(); }

std::string unit_of_values(const std::vector<HeadLine>& lines, const std::string& known,
                           const Reading& reading) {
  UnitReader out;
  for (const HeadLine& line : lines) out.read(line);
  return out.settled(known, reading.unit_told);
}

}  // namespace asperity
