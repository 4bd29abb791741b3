#include "vehicles/reader/file_tags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <system_error>

#include "analysis/text/number.h"
#include "analysis/text/units.h"
#include "vehicles/curves/curve_file.h"
#include "vehicles/description/design_poses.h"
#include "vehicles/reader/findings.h"
#include "vehicles/reader/urdf_reader.h"
#include "vehicles/tags/tag.h"
#include "vehicles/tags/xml_limits.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

struct PointNames {
  const char* x;
  const char* unit;
};

class FileTags {
 public:
  FileTags(XMLElement& robot, FileFaults& faults) : robot_(robot), faults_(faults) {}

  std::vector<FileContent> Fill() {
    for (const char* tag : {"fp:spring", "fp:damper", "fp:tyre"})
      for (XMLElement* element : Children(robot_, tag))
        for (XMLElement* table : Children(*element, "table"))
          if (AttributeText(*table, "file")) FillTable(*element, *table);
    for (XMLElement* element : Children(robot_, "fp:bushing"))
      if (AttributeText(*element, "file")) FillBushing(*element);
    return std::move(contents_);
  }

 private:
  void FillTable(XMLElement& element, XMLElement& table) {
    if (table.FirstChildElement("point")) {
      faults_.Report(kFileAndPoints, LineOf(table, "file"), {Describe(table)});
      return;
    }
    const std::string path = PathOf(table);
    if (path.empty()) return;
    FileContent content{.tag = element.Name(),
                        .name = NameOf(element),
                        .file = MeshPath(faults_.file(), *AttributeText(table, "file")).string()};
    if (content.tag == "fp:spring") {
      const std::optional<SpringCurve>& curve = Read(springs_, path, &ReadSpringCurve);
      if (!curve || !HasRoom(table, curve->points.size())) return;
      AddPoints(table, curve->points, {"extension", "mm"});
      content.lacks_place = !AttributeText(table, "at");
      content.free_length = curve->free_length;
    } else {
      const bool is_tyre = content.tag == "fp:tyre";
      const std::optional<std::vector<CurvePoint>>& curve =
          is_tyre ? Read(tyres_, path, &ReadTyreCurve) : Read(dampers_, path, &ReadDamperCurve);
      if (!curve || !HasRoom(table, curve->size())) return;
      AddPoints(table, *curve, is_tyre ? PointNames{"deflection", "mm"} : PointNames{"speed", "m/s"});
    }
    content.xml = InnerText(table);
    contents_.push_back(std::move(content));
  }

  void FillBushing(XMLElement& bushing) {
    const std::string path = PathOf(bushing);
    if (path.empty()) return;
    const std::optional<BushingRates>& rates = Read(bushings_, path, &ReadBushingRates);
    if (!rates || !HasRoom(bushing, 4)) return;
    FileContent content{.tag = bushing.Name(),
                        .name = NameOf(bushing),
                        .file = MeshPath(faults_.file(), *AttributeText(bushing, "file")).string()};
    const auto add = [&](const char* name, const std::array<double, 6>& values, std::size_t first, const char* unit) {
      if (bushing.FirstChildElement(name)) return;
      XMLElement& made = Make(bushing, name);
      for (std::size_t i = 0; i < 3; ++i)
        made.SetAttribute(std::array{"x", "y", "z"}[i], FormatQuantity(values[first + i], unit).c_str());
      bushing.InsertEndChild(&made);
      content.xml += Printed(made);
    };
    add("translation", rates->stiffness, 0, "N/mm");
    add("rotation", rates->stiffness, 3, "N*m/rad");
    add("translation_damping", rates->damping, 0, "N*s/m");
    add("rotation_damping", rates->damping, 3, "N*m*s/rad");
    contents_.push_back(std::move(content));
  }

  /// Empty, with a fault, where there is no such file.
  std::string PathOf(const XMLElement& element) {
    const std::string name = *AttributeText(element, "file");
    // An empty attribute is reported with the other attributes.
    if (Trimmed(name).empty()) {
      faults_.Follow();
      return "";
    }
    const std::filesystem::path path = (std::filesystem::path(faults_.file()).parent_path() / name).lexically_normal();
    std::error_code failure;
    if (std::filesystem::exists(path, failure)) return path.string();
    faults_.Report(kFileMissing, LineOf(element, "file"),
                   {"file=\"" + name + "\" of " + Describe(element), path.string()});
    return "";
  }

  /// Once for all tags that name the file.
  template <typename Curve>
  const std::optional<Curve>& Read(std::map<std::string, std::optional<Curve>>& known, const std::string& path,
                                   std::optional<Curve> (*read)(const std::filesystem::path&, Diagnostics&)) {
    const auto [found, is_new] = known.try_emplace(path);
    if (!is_new) {
      if (!found->second) faults_.Follow();
      return found->second;
    }
    Diagnostics diagnostics;
    found->second = read(path, diagnostics);
    faults_.Take(diagnostics);
    return found->second;
  }

  /// For so many more tags, of which files may give as many as a vehicle file may have. Else a fault, the first one
  /// reported.
  bool HasRoom(const XMLElement& element, std::size_t more) {
    made_ += more;
    if (made_ <= kMostXmlElements) return true;
    if (made_ - more <= kMostXmlElements)
      faults_.Report(kFileTags, LineOf(element, "file"), {std::to_string(kMostXmlElements)});
    else faults_.Follow();
    return false;
  }

  static void AddPoints(XMLElement& table, const std::vector<CurvePoint>& points, const PointNames& names) {
    for (const CurvePoint& point : points) {
      XMLElement& made = Make(table, "point");
      made.SetAttribute(names.x, FormatQuantity(point.x, names.unit).c_str());
      made.SetAttribute("force", FormatQuantity(point.force, "N").c_str());
      table.InsertEndChild(&made);
    }
  }

  static XMLElement& Make(XMLElement& origin, const char* name) {
    XMLElement& made = *origin.GetDocument()->NewElement(name);
    SetOrigin(made, origin);
    return made;
  }

  static std::string Printed(const XMLElement& element) {
    tinyxml2::XMLPrinter printer(nullptr, true);
    element.Accept(&printer);
    return "\n      " + std::string(printer.CStr());
  }

  static std::string InnerText(const XMLElement& table) {
    std::string text;
    for (const XMLElement* point : Children(table)) text += Printed(*point);
    return text;
  }

  XMLElement& robot_;
  FileFaults& faults_;
  std::vector<FileContent> contents_;
  std::size_t made_ = 0;
  std::map<std::string, std::optional<SpringCurve>> springs_;
  std::map<std::string, std::optional<std::vector<CurvePoint>>> dampers_;
  std::map<std::string, std::optional<std::vector<CurvePoint>>> tyres_;
  std::map<std::string, std::optional<BushingRates>> bushings_;
};

double DesignLength(const ForceLine& line, const std::vector<Eigen::Isometry3d>& poses) {
  return (PlaceOf(line.parent, poses) - PlaceOf(line.child, poses)).norm();
}

/// The name under which an element is written.
const std::string& WrittenName(const Vehicle& vehicle, const std::string& name) {
  const auto twin = vehicle.twins.find(name);
  return twin == vehicle.twins.end() ? name : twin->second;
}

/// What a spring's table without `at` takes from a file; nullptr of any other spring.
FileContent* Unplaced(Vehicle& vehicle, const Spring& spring) {
  const bool has_ends = spring.line.parent.link >= 0 && spring.line.child.link >= 0;
  if (spring.kind != Spring::Kind::kCoil || spring.law.table.size() < 2 || !has_ends) return nullptr;
  const std::string& name = WrittenName(vehicle, spring.name);
  const auto found = std::find_if(vehicle.contents.begin(), vehicle.contents.end(), [&](const FileContent& content) {
    return content.lacks_place && content.tag == "fp:spring" && content.name == name;
  });
  return found == vehicle.contents.end() ? nullptr : &*found;
}

std::string Shown(double metres) { return FormatNumber(std::round(metres * 1e6) + 0.0, -3) + " mm"; }

}  // namespace

std::vector<FileContent> FillFileTags(XMLElement& robot, FileFaults& faults) { return FileTags(robot, faults).Fill(); }

void PlaceOnCurves(Vehicle& vehicle, FileFaults& faults) {
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  for (Spring& spring : vehicle.springs) {
    FileContent* content = Unplaced(vehicle, spring);
    if (!content) continue;
    if (content->free_length && spring.line.axis) {
      faults.Report(kCurvePlaceGuided, spring.source_line, {spring.Element()});
      continue;
    }
    const double length = DesignLength(spring.line, poses);
    const double at = content->free_length ? length - *content->free_length : 0;
    if (content->free_length) content->at = spring.law.place.value = at;
    spring.law.is_placed = content->free_length.has_value();
    const double least = spring.law.table.front().extension.value;
    const double greatest = spring.law.table.back().extension.value;
    if (least <= at && at <= greatest) continue;
    if (content->free_length)
      faults.Report(
          kCurvePlace, spring.source_line,
          {spring.Element(), Shown(length), Shown(*content->free_length), Shown(at), Shown(least), Shown(greatest)});
    else faults.Report(kSpringTablePlace, spring.source_line, {"at=\"0 m\" of " + spring.Element()});
  }
}

const FileContent* ContentOf(const Vehicle& vehicle, const XMLElement& element) {
  const auto found = std::find_if(vehicle.contents.begin(), vehicle.contents.end(), [&](const FileContent& content) {
    return content.tag == element.Name() && content.name == NameOf(element);
  });
  return found == vehicle.contents.end() ? nullptr : &*found;
}

}  // namespace fourpost
