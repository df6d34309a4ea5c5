#include "formats/text_units.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "formats/refuse.hpp"
#include "formats/text_labels.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

constexpr std::string_view separators = ":=;,\t";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool separates(char c) { return separators.find(c) != separators.npos; }

template <class Names>
bool has_one_of(std::string_view word, const Names& names) {
  return std::ranges::any_of(names, [&](std::string_view name) { return word.find(name) != word.npos; });
}

struct Word {
  std::string_view text;
  char before;  // a separator, a blank, or '\n' at the beginning of the line
  bool brackets;
};

// Where a word ends: a comma between digits is part of it.
std::size_t end_of_word(std::string_view line) {
  std::size_t end = 0;
  do end = std::min(line.find_first_of(" \"[(:=;,\t", end + 1), line.size());
  while (end + 1 < line.size() && line[end] == ',' && is_digit(line[end - 1]) && is_digit(line[end + 1]));
  return end;
}

// Brackets are one word, with what they contain.
std::vector<Word> words_in(std::string_view line) {
  std::vector<Word> out;
  for (char before = '\n'; !line.empty();) {
    if (line[0] == ' ' || line[0] == '"' || separates(line[0])) {
      if (separates(line[0])) before = line[0];
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
  return unit.ends_with('m') || has_one_of(unit, names);
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

// What the words before a unit or a number tell.
struct Subject {
  bool z = false, height = false, lateral = false, other = false, unit = false, factor = false;

  void add(std::string_view word) {
    const std::string name = lower(word);
    if (name.find("bit2") != name.npos) return static_cast<void>(factor = true);
    const auto letter = [](unsigned char c) { return c >= 0x80 || std::isalpha(c) != 0; };
    for (auto from = std::ranges::find_if(name, letter); from != name.end();) {
      const auto end = std::find_if_not(from, name.end(), letter);
      add_part(std::string(from, end));
      from = std::find_if(end, name.end(), letter);
    }
  }

  bool empty() const { return !(z || height || lateral || other || unit || factor); }
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
    const bool letters = part.find_first_not_of("xyz") == part.npos, has_z = part.find('z') != part.npos;
    const CoordinateRole role = role_of(part);
    if (letters)
      (has_z ? z : lateral) = true;
    else if (role == CoordinateRole::x || has_one_of(part, along))
      lateral = true;
    else
      (role == CoordinateRole::z || has_one_of(part, values) ? height : other) = true;
  }
};

class Statements {
 public:
  void read(const HeadLine& line) {
    std::string_view text = line.text;
    text.remove_prefix(std::min(text.find_first_not_of("#%;\\ \t"), text.size()));
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
      refuse(
          "line {}: a factor of the values: give asperity-convert their unit, which contains it (`unit` "
          "'2.5e-9 m')",
          scaled_);
    if (differ)
      refuse(
          "its head gives the values the unit {} and the unit {}: remove one of the lines, or give "
          "asperity-convert the right one (`unit`)",
          quoted(unit), quoted(same_length(unit, unit_) ? last_ : unit_));
    if (unit.empty() && !told && unclear_line_ > 0)
      refuse(
          "line {}: {} may be the unit of the values: give it to asperity-convert (`unit`), or the right "
          "one",
          unclear_line_, quoted(unclear_));
    return unit;
  }

 private:
  void read_words(const std::vector<Word>& words) {
    Subject last, subject;
    std::string pending;    // a unit, if no number follows
    bool quantity = false;  // the word before is the number of one
    const auto settle = [&] {
      if (pending.empty()) return;
      state(subject.empty() ? last : subject, std::exchange(pending, ""));
      last = std::exchange(subject, {});
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
      const auto& [text, before, brackets] = words[i];
      if (!brackets && begins_like_number(text)) {
        if ((subject.factor || multiple(words, i)) && subject.of_values() && number_of(text) != 1.0)
          scaled_ = line_;
        quantity = separates(before) || !pending.empty();
        pending.clear();
        if (quantity) subject = {};
        continue;
      }
      if (text == "per") pending.clear();
      settle();
      const std::string unit = unit_at(words, i, subject);
      if (unit.empty())
        subject.add(text);
      else if (!quantity)
        pending = unit;
      quantity = false;
    }
    settle();
  }

  // "in 1e-9 m".
  static bool multiple(const std::vector<Word>& words, std::size_t i) {
    return i > 0 && i + 1 < words.size() && lower(words[i - 1].text) == "in" &&
           !length_in(words[i + 1].text).empty();
  }

  static std::string unit_at(const std::vector<Word>& words, std::size_t i, Subject& subject) {
    const auto& [text, before, brackets] = words[i];
    if (brackets) return unit_in_brackets(text);
    const Label label = label_of(text);
    Subject named, former;
    named.add(label.name);
    if (!label.unit.empty() && !named.empty() && !named.other) {
      subject.add(label.name);
      return label.unit;
    }
    const std::string_view before_it = i > 0 ? words[i - 1].text : "";
    former.add(before_it);
    const bool last = i + 1 == words.size() || words[i + 1].before != ' ' || words[i + 1].brackets;
    const bool behind_in = before == ' ' && lower(before_it) == "in";
    const bool named_before = !former.empty() && !former.other;
    const bool prompted = last && (before != ' ' || named_before || before_it == "of");
    const std::string length = behind_in || prompted ? length_in(text) : "";
    return behind_in || is_metric(length) ? length : "";
  }

  // "Units: counts".
  void read_key(std::string_view text) {
    const std::size_t end = text.find_first_of(separators);
    if (end == text.npos) return;
    Subject key;
    key.add(text.substr(0, end));
    const std::string_view value = text.substr(end + 1),
                           unit = trimmed(value.substr(0, value.find_first_of(";,\t")));
    if (key.unit && key.of_values() && !unit.empty()) state(key, std::string(unit));
  }

  void state(const Subject& subject, std::string unit) {
    some_ = true;
    if (subject.of_coordinates()) return;
    if (!subject.of_values()) {
      unclear_line_ = line_;
      unclear_ = std::move(unit);
    } else if (unit_.empty()) {
      unit_ = last_ = std::move(unit);
    } else if (same_length(unit_, last_)) {
      last_ = std::move(unit);
    }
  }

  std::size_t line_ = 0, unclear_line_ = 0, scaled_ = 0;
  bool some_ = false;  // the line has a unit
  std::string unit_, last_, unclear_;
};

}  // namespace

std::string unit_of_values(const std::vector<HeadLine>& head, const std::string& known,
                           const Reading& reading) {
  Statements out;
  for (const HeadLine& line : head) out.read(line);
  return out.settled(known, reading.unit_told);
}

bool names_coordinates(std::string_view name) {
  Subject out;
  out.add(name);
  return out.of_coordinates();
}

std::vector<HeadLine> head_lines(std::string_view text) {
  std::vector<HeadLine> out;
  for (std::size_t number = 1; !text.empty(); ++number) out.push_back({number, take_line(text)});
  return out;
}

}  // namespace asperity
