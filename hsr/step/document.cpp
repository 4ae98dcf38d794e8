#include "hsr/step/document.h"

#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <istream>
#include <mutex>
#include <optional>
#include <set>
#include <streambuf>
#include <utility>

#include "geometry/error.h"
#include "hsr/step/fault_guard.h"

namespace hsr::internal {

namespace {

std::mutex one_at_a_time;

/// The bytes as a stream, without copying them.
class BytesBuffer : public std::streambuf {
 public:
  explicit BytesBuffer(std::string_view bytes) {
    char* const begin = const_cast<char*>(bytes.data());  // it is only read
    setg(begin, begin, begin + bytes.size());
  }
};

struct KnownUnit {
  const char* name;  // as STEP names it, in lower case
  const char* setting;
  double millimetres;
};
/// Those that hsr has; all others are converted to the first.
constexpr std::array<KnownUnit, 5> known_units = {
    {{"millimetre", "MM", 1}, {"centimetre", "CM", 10}, {"metre", "M", 1000}, {"inch", "INCH", 25.4}, {"in", "INCH", 25.4}}};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The unit that the shapes shall have, if the file has one of hsr's.
std::optional<KnownUnit> common_unit(const TColStd_SequenceOfAsciiString& names) {
  std::optional<KnownUnit> found;
  for (int k = 1; k <= names.Length(); ++k) {
    const std::string name = lower(names(k).ToCString());
    const auto* const unit =
        std::find_if(known_units.begin(), known_units.end(), [&](const KnownUnit& u) { return name == u.name; });
    if (unit == known_units.end() || (found && found->millimetres != unit->millimetres)) return std::nullopt;
    found = *unit;
  }
  return found;
}

/// A document that no application keeps.
Handle(TDocStd_Document) new_document() { return new TDocStd_Document("BinXCAF"); }

void say_nothing() { Message::DefaultMessenger()->ChangePrinters().Clear(); }

/// A note on entities that were not understood, or of which nothing was made; or none.
void note_failures(BrepDocument& document, const XSControl_Reader& reader) {
  std::set<int> failed;
  const Handle(XSControl_WorkSession) session = reader.WS();
  for (const Interface_CheckIterator& found : {session->ModelCheckList(false), session->TransferReader()->LastCheckList()})
    for (found.Start(); found.More(); found.Next())
      if (found.Value()->HasFailed()) failed.insert(found.Number());
  if (!failed.empty())
    document.notes.push_back("entities that Open CASCADE does not understand are left out, with what is made of them: " +
                             std::to_string(failed.size()));
}

/// Open CASCADE goes on for ever from a coordinate that is no number.
void expect_numbers(const std::string& path, std::string_view bytes) {
  std::size_t line = 1;
  bool is_in_string = false;
  char before = ' ';
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    const char c = bytes[k];
    if (c == '\n') ++line;
    if (c == '\'') is_in_string = !is_in_string;
    const bool begins_value = before == '(' || before == ',' || before == '+' || before == '-';
    if (!is_in_string && begins_value && (c == 'n' || c == 'N' || c == 'i' || c == 'I')) {
      const std::string word = lower(std::string(bytes.substr(k, 3)));
      const char after = k + 3 < bytes.size() ? bytes[k + 3] : ')';
      if ((word == "nan" || word == "inf") && (after == ')' || after == ',' || after == ' ' || after == '\r' || after == '\n'))
        throw InputError(path + ": line " + std::to_string(line) + ": found \"" + std::string(bytes.substr(k, 3)) +
                         "\", expected a finite number");
    }
    if (c != ' ' && c != '\n' && c != '\r') before = c;
  }
}

[[noreturn]] void refuse(const std::string& path, const std::string& what) { throw InputError(path + ": " + what); }

BrepDocument transferred_step(const std::string& path, std::string_view bytes) {
  try {
    STEPCAFControl_Reader reader;
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    BytesBuffer buffer(bytes);
    std::istream stream(&buffer);
    if (reader.ChangeReader().ReadStream(path.c_str(), stream) != IFSelect_RetDone)
      refuse(path,
             "found STEP that Open CASCADE cannot read, expected entities of ISO 10303-21 from HEADER to END-ISO-10303-21");
    BrepDocument document{new_document(), "STEP", 1, {}};
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
    const auto unit = common_unit(lengths);
    Interface_Static::SetCVal("xstep.cascade.unit", unit ? unit->setting : "MM");
    if (unit) document.millimetres = unit->millimetres;
    if (!unit && lengths.Length() > 0)
      document.notes.push_back("lengths in the file's unit (" + std::string(lengths(1).ToCString()) +
                               (lengths.Length() > 1 ? " and others" : "") + ") are converted to mm");
    const bool is_done = reader.Transfer(document.shapes);
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    if (!is_done) refuse(path, "found STEP without a shape, expected surfaces or solids");
    note_failures(document, reader.Reader());
    return document;
  } catch (const Standard_Failure& failure) {
    refuse(path, "found STEP that Open CASCADE cannot read (" + std::string(failure.DynamicType()->Name()) +
                     "), expected ISO 10303-21");
  }
}

BrepDocument transferred_iges(const std::string& path) {
  try {
    IGESCAFControl_Reader reader;
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
      refuse(path, "found IGES that Open CASCADE cannot read, expected sections S, G, D, P and T");
    BrepDocument document{new_document(), "IGES", 1, {}};
    if (const auto model = Handle(IGESData_IGESModel)::DownCast(reader.Model()); !model.IsNull())
      if (const auto name = model->GlobalSection().UnitName(); !name.IsNull() && lower(name->ToCString()) != "mm")
        document.notes.push_back("lengths in the file's unit (" + std::string(name->ToCString()) + ") are converted to mm");
    if (!reader.Transfer(document.shapes)) refuse(path, "found IGES without a shape, expected surfaces or solids");
    note_failures(document, reader);
    return document;
  } catch (const Standard_Failure& failure) {
    refuse(path, "found IGES that Open CASCADE cannot read (" + std::string(failure.DynamicType()->Name()) +
                     "), expected sections S, G, D, P and T");
  }
}

/// One after the other, as Open CASCADE's settings are those of the whole program.
BrepDocument survived(const std::string& path, const std::function<BrepDocument()>& read) {
  const std::scoped_lock lock(one_at_a_time);
  say_nothing();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");  // another file may have failed with its own
  std::optional<BrepDocument> document;
  try {
    survive_faults([&] { document = read(); });
  } catch (const Standard_Failure& failure) {
    refuse(path, "found something on which Open CASCADE fails (" + std::string(failure.DynamicType()->Name()) +
                     "), expected a file without missing or broken entities");
  }
  return *std::move(document);
}

}  // namespace

BrepDocument read_step_document(const std::string& path, std::string_view bytes) {
  expect_numbers(path, bytes);
  return survived(path, [&] { return transferred_step(path, bytes); });
}

BrepDocument read_iges_document(const std::string& path) {
  return survived(path, [&] { return transferred_iges(path); });
}

}  // namespace hsr::internal
