#include "analysis/text/name_meaning.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <vector>

namespace fourpost {
namespace {

struct Corner {
  int front;
  int left;
};

const std::map<std::string, Corner, std::less<>> kCorners = {
    {"fl", {1, 1}},        {"lf", {1, 1}},          {"vl", {1, 1}},       {"fr", {1, -1}},       {"rf", {1, -1}},
    {"vr", {1, -1}},       {"rl", {-1, 1}},         {"lr", {-1, 1}},      {"hl", {-1, 1}},       {"rr", {-1, -1}},
    {"hr", {-1, -1}},      {"front", {1, 0}},       {"frt", {1, 0}},      {"fore", {1, 0}},      {"vorne", {1, 0}},
    {"vorn", {1, 0}},      {"rear", {-1, 0}},       {"back", {-1, 0}},    {"aft", {-1, 0}},      {"hinten", {-1, 0}},
    {"left", {0, 1}},      {"lh", {0, 1}},          {"links", {0, 1}},    {"right", {0, -1}},    {"rh", {0, -1}},
    {"rechts", {0, -1}},   {"anteriore", {1, 0}},   {"ant", {1, 0}},      {"avant", {1, 0}},     {"delantero", {1, 0}},
    {"delantera", {1, 0}}, {"posteriore", {-1, 0}}, {"arriere", {-1, 0}}, {"trasero", {-1, 0}},  {"trasera", {-1, 0}},
    {"sinistro", {0, 1}},  {"sinistra", {0, 1}},    {"gauche", {0, 1}},   {"izquierdo", {0, 1}}, {"izquierda", {0, 1}},
    {"izq", {0, 1}},       {"destro", {0, -1}},     {"destra", {0, -1}},  {"droite", {0, -1}},   {"droit", {0, -1}},
    {"derecho", {0, -1}},  {"derecha", {0, -1}}};

const std::map<std::string, std::string, std::less<>> kWords = {
    {"chassis", "body"},      {"sprung", "body"},       {"frame", "body"},        {"cab", "body"},
    {"aufbau", "body"},       {"top", "body"},          {"hub", "axle"},          {"unsprung", "axle"},
    {"upright", "axle"},      {"knuckle", "axle"},      {"wheel", "axle"},        {"achse", "axle"},
    {"rad", "axle"},          {"spindle", "axle"},      {"damper", "strut"},      {"shock", "strut"},
    {"spring", "strut"},      {"susp", "strut"},        {"suspension", "strut"},  {"lvdt", "strut"},
    {"defl", "strut"},        {"deflection", "strut"},  {"travel", "strut"},      {"pot", "strut"},
    {"feder", "strut"},       {"tire", "tyre"},         {"load", "tyre"},         {"loadcell", "tyre"},
    {"cell", "tyre"},         {"pan", "tyre"},          {"wheelpan", "tyre"},     {"fz", "tyre"},
    {"contact", "tyre"},      {"radlast", "tyre"},      {"actuator", "post"},     {"act", "post"},
    {"ram", "post"},          {"platform", "post"},     {"road", "post"},         {"ground", "post"},
    {"exciter", "post"},      {"table", "post"},        {"stempel", "post"},      {"cog", "cg"},
    {"centre", "cg"},         {"center", "cg"},         {"karo", "body"},         {"karosserie", "body"},
    {"kar", "body"},          {"bdy", "body"},          {"chass", "body"},        {"fahrgestell", "body"},
    {"radtraeger", "axle"},   {"whl", "axle"},          {"nabe", "axle"},         {"fw", "strut"},
    {"federweg", "strut"},    {"daempfer", "strut"},    {"federbein", "strut"},   {"dmp", "strut"},
    {"damp", "strut"},        {"spr", "strut"},         {"shk", "strut"},         {"reifen", "tyre"},
    {"radkraft", "tyre"},     {"kmd", "tyre"},          {"lc", "tyre"},           {"zylinder", "post"},
    {"zyl", "post"},          {"cylinder", "post"},     {"cyl", "post"},          {"hydropuls", "post"},
    {"plattform", "post"},    {"plat", "post"},         {"cassa", "body"},        {"scocca", "body"},
    {"telaio", "body"},       {"carrozzeria", "body"},  {"mozzo", "axle"},        {"portamozzo", "axle"},
    {"ruota", "axle"},        {"fusello", "axle"},      {"asse", "axle"},         {"ammortizzatore", "strut"},
    {"molla", "strut"},       {"sospensione", "strut"}, {"carico", "tyre"},       {"pneumatico", "tyre"},
    {"gomma", "tyre"},        {"attuatore", "post"},    {"pistone", "post"},      {"martinetto", "post"},
    {"cilindro", "post"},     {"pedana", "post"},       {"caisse", "body"},       {"carrosserie", "body"},
    {"moyeu", "axle"},        {"roue", "axle"},         {"essieu", "axle"},       {"fusee", "axle"},
    {"amortisseur", "strut"}, {"ressort", "strut"},     {"debattement", "strut"}, {"charge", "tyre"},
    {"pneu", "tyre"},         {"verin", "post"},        {"actionneur", "post"},   {"carroceria", "body"},
    {"chasis", "body"},       {"bastidor", "body"},     {"rueda", "axle"},        {"buje", "axle"},
    {"cubo", "axle"},         {"mangueta", "axle"},     {"eje", "axle"},          {"amortiguador", "strut"},
    {"muelle", "strut"},      {"resorte", "strut"},     {"recorrido", "strut"},   {"carga", "tyre"},
    {"neumatico", "tyre"},    {"actuador", "post"}};

/// What a unit says as well, and what says nothing.
constexpr std::array<std::string_view, 40> kQuantities = {
    "a",      "acc",      "accel",         "acceleration", "s",     "z",           "x",           "y",
    "f",      "force",    "disp",          "displacement", "pos",   "position",    "height",      "level",
    "ch",     "channel",  "sensor",        "static",       "kraft", "weg",         "beschl",      "beschleunigung",
    "signal", "forza",    "fuerza",        "effort",       "corsa", "course",      "carrera",     "posizione",
    "spost",  "posicion", "accelerazione", "deplacement",  "acel",  "aceleracion", "spostamento", "segnale"};

bool IsQuantity(std::string_view word) {
  return std::find(kQuantities.begin(), kQuantities.end(), word) != kQuantities.end();
}

bool IsSmall(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool IsCapital(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool IsDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Letters of UTF-8 up to U+00FF as ASCII has them, umlauts as two: "Dämpfer" is "Daempfer", "vérin" is "verin".
std::string WithoutAccents(std::string_view name) {
  // From U+00C0 to U+00DF, and their small letters from U+00E0 on.
  constexpr std::array<std::string_view, 32> kPlain = {"A",  "A", "A", "A", "AE", "A", "AE", "C", "E", "E", "E",
                                                       "E",  "I", "I", "I", "I",  "D", "N",  "O", "O", "O", "O",
                                                       "OE", "",  "O", "U", "U",  "U", "UE", "Y", "",  "SS"};
  constexpr unsigned kLead = 0xC3;
  constexpr unsigned kSmall = 0xA0;
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const unsigned next = i + 1 < name.size() ? static_cast<unsigned char>(name[i + 1]) : 0;
    if (static_cast<unsigned char>(name[i]) != kLead || next < 0x80 || next > 0xBF) {
      plain += name[i];
      continue;
    }
    const std::string_view letter = kPlain[(next - 0x80) % kPlain.size()];
    for (const char c : letter) plain += next >= kSmall ? static_cast<char>(std::tolower(c)) : c;
    ++i;
  }
  return plain;
}

/// The corner at the end of "zfl" and "accrr", which goes from the word then.
std::optional<Corner> CornerBehind(std::string& word) {
  if (word.size() < 3) return std::nullopt;
  const std::string head = word.substr(0, word.size() - 2);
  const auto corner = kCorners.find(word.substr(word.size() - 2));
  if (corner == kCorners.end() || (!IsQuantity(head) && !kWords.contains(head))) return std::nullopt;
  word = head;
  return corner->second;
}

/// Words that mean places beside each other, where none of `unless` is there as well.
struct Siblings {
  const char* one;
  const char* other;
  Corner of_one;
  Corner of_other;
  std::array<const char*, 2> unless;
};

const std::array<Siblings, 11> kSiblings = {{{"f", "r", {1, 0}, {-1, 0}, {"l", ""}},
                                             {"v", "h", {1, 0}, {-1, 0}, {"l", ""}},
                                             {"l", "r", {0, 1}, {0, -1}, {"f", "v"}},
                                             {"li", "re", {0, 1}, {0, -1}, {"fr", ""}},
                                             {"fr", "re", {1, 0}, {-1, 0}, {"li", "fl"}},
                                             {"vo", "hi", {1, 0}, {-1, 0}, {"", ""}},
                                             {"va", "ha", {1, 0}, {-1, 0}, {"", ""}},
                                             {"fa", "ra", {1, 0}, {-1, 0}, {"", ""}},
                                             {"f", "b", {1, 0}, {-1, 0}, {"r", "l"}},
                                             {"sx", "dx", {0, 1}, {0, -1}, {"", ""}},
                                             {"av", "ar", {1, 0}, {-1, 0}, {"", ""}}}};

/// What a word means beside the other words that names of its kind have in its place.
std::optional<Corner> CornerAmong(const std::string& word, const std::set<std::string>& kin) {
  for (const Siblings& pair : kSiblings) {
    if (word != pair.one && word != pair.other) continue;
    const bool are_there = kin.contains(pair.one) && kin.contains(pair.other);
    if (are_there && !kin.contains(pair.unless[0]) && !kin.contains(pair.unless[1]))
      return word == pair.one ? pair.of_one : pair.of_other;
  }
  return std::nullopt;
}

/// Of the last word of a name that has others.
std::optional<Corner> CornerAlone(const std::string& word, bool has_sides) {
  if (word == "f") return Corner{1, 0};
  if (word == "l") return Corner{0, 1};
  if (word == "r" && !has_sides) return Corner{-1, 0};
  return std::nullopt;
}

bool HasCorner(const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(),
                     [](std::string word) { return kCorners.contains(word) || CornerBehind(word); });
}

/// By the place of the word.
using Places = std::map<std::size_t, Corner>;

NameMeaning MeaningOfWords(const std::vector<std::string>& words, const Places& places) {
  NameMeaning meaning;
  const auto add = [&](const Corner& corner) {
    if (corner.front != 0) meaning.front = corner.front;
    if (corner.left != 0) meaning.left = corner.left;
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string word = words[i];
    if (const auto place = places.find(i); place != places.end()) {
      add(place->second);
      continue;
    }
    if (const auto corner = kCorners.find(word); corner != kCorners.end()) {
      add(corner->second);
      continue;
    }
    if (const std::optional<Corner> corner = CornerBehind(word)) add(*corner);
    if (IsQuantity(word)) continue;
    const auto known = kWords.find(word);
    meaning.words.insert(known == kWords.end() ? word : known->second);
  }
  return meaning;
}

}  // namespace

std::vector<std::string> WordsOf(std::string_view name) {
  std::vector<std::string> words(1);
  char last = ' ';
  for (const char c : WithoutAccents(name)) {
    const bool is_word = std::isalnum(static_cast<unsigned char>(c)) != 0;
    const bool begins = !is_word || (IsCapital(c) && IsSmall(last)) || (IsDigit(c) != IsDigit(last));
    if (begins && !words.back().empty()) words.emplace_back();
    if (is_word) words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    last = c;
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

NameMeaning MeaningOf(std::string_view name) { return MeaningOfWords(WordsOf(name), {}); }

std::vector<NameMeaning> MeaningsOf(const std::vector<std::string>& names, bool has_sides) {
  std::vector<std::vector<std::string>> all;
  /// What stands in one place of names that are else alike.
  std::map<std::pair<std::size_t, std::vector<std::string>>, std::set<std::string>> kin;
  const auto others = [](std::vector<std::string> words, std::size_t place) {
    words[place] = "";
    return std::pair(place, std::move(words));
  };
  for (const std::string& name : names) {
    all.push_back(WordsOf(name));
    for (std::size_t i = 0; i < all.back().size(); ++i)
      if (all.back()[i].size() <= 2) kin[others(all.back(), i)].insert(all.back()[i]);
  }
  std::vector<NameMeaning> meanings;
  for (const std::vector<std::string>& words : all) {
    Places places;
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words.size() < 2 || words[i].size() > 2) continue;
      std::optional<Corner> corner = CornerAmong(words[i], kin.at(others(words, i)));
      const bool is_last = i + 1 == words.size();
      if (!corner && is_last && places.empty() && !HasCorner(words)) corner = CornerAlone(words[i], has_sides);
      if (corner) places.emplace(i, *corner);
    }
    meanings.push_back(MeaningOfWords(words, places));
  }
  return meanings;
}

bool NameOtherParts(const NameMeaning& one, const NameMeaning& other) {
  constexpr std::array<const char*, 6> kParts = {"body", "axle", "strut", "tyre", "post", "cg"};
  const auto has = [](const NameMeaning& meaning) {
    return [&](const char* part) { return meaning.words.contains(part); };
  };
  const auto is_common = [&](const char* part) { return has(one)(part) && has(other)(part); };
  return std::any_of(kParts.begin(), kParts.end(), has(one)) && std::any_of(kParts.begin(), kParts.end(), has(other)) &&
         std::none_of(kParts.begin(), kParts.end(), is_common);
}

double Likeness(const NameMeaning& one, const NameMeaning& other) {
  if (one.front * other.front < 0 || one.left * other.left < 0) return -1;
  std::vector<std::string> common;
  std::set_intersection(one.words.begin(), one.words.end(), other.words.begin(), other.words.end(),
                        std::back_inserter(common));
  const double all = static_cast<double>(one.words.size() + other.words.size() - common.size());
  const double words = all > 0 ? static_cast<double>(common.size()) / all : 0;
  // A place that one says and the other does not speaks against them.
  const auto place = [](int a, int b) { return a == b ? (a == 0 ? 0.5 : 1.0) : 0.0; };
  return 0.5 * words + 0.25 * place(one.front, other.front) + 0.25 * place(one.left, other.left);
}

}  // namespace fourpost
