// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "controllers/src/codesys/cam_xyva.hpp"
#include "controllers/src/exchange/formats.hpp"

// A cam of CODESYS SoftMotion as PLCopen XML (TC6): a list of global variables with initial values,
// an array of SMC_CAMXYVA and its MC_CAM_REF. CODESYS keeps such a list in the additional data of
// the project, under the name below, and reads it from there.
namespace jounce::controllers_detail {
namespace {

constexpr const char* list_of_globals = "http://www.3s-software.com/plcopenxml/globalvars";

/// The points of a value of an array, which may stand for several equal points.
void read_points(const pugi::xml_node& value, const std::string& name, const std::string& text,
                 const Place& place, KnotArray& array) {
  const int line = line_at(text, value.offset_debug());
  Knot knot;
  knot.line = line;
  for (const auto& member : value.child("structValue").children("value")) {
    const std::string field = member.attribute("member").value();
    const std::string number = member.child("simpleValue").attribute("value").value();
    for (std::size_t i = 0; i < cam_xyva.fields.size(); ++i) {
      if (lower(field) != lower(cam_xyva.fields[i])) continue;
      knot.values[i] =
          place.number(line_at(text, member.offset_debug()), name + "." + field, number);
      knot.given[i] = true;
    }
  }
  if (const pugi::xml_attribute times = value.attribute("repetitionValue");
      times && times.as_int() != 1)
    place.fail(line, name, times.value(), "must be 1: the positions of the master must ascend");
  array.knots.push_back(std::move(knot));
}

std::vector<Exchanged> read_plcopen(const std::string& text, const Place& place) {
  pugi::xml_document document;
  if (const auto result = document.load_buffer(text.data(), text.size()); !result)
    place.fail(line_at(text, result.offset), "", "",
               std::string("is not XML: ") + result.description());
  std::vector<Exchanged> cams;
  for (const auto& found : document.select_nodes("//variable[type/array/baseType/derived]")) {
    const pugi::xml_node variable = found.node();
    const std::string type =
        variable.select_node("type/array/baseType/derived/@name").attribute().value();
    if (lower(unqualified(type)) != lower(cam_xyva.name)) continue;
    KnotArray array{.name = variable.attribute("name").value()};
    for (const auto& value : variable.child("initialValue").child("arrayValue").children("value"))
      read_points(value, array.name, text, place, array);
    if (array.knots.empty())
      place.fail(line_at(text, variable.offset_debug()), array.name, "", "has no initial values");
    cams.push_back(cam_of_knots(array, cam_xyva, Interpolation::quintic_hermite));
  }
  if (cams.empty())
    place.fail(1, "", "", "contains no array of SMC_CAMXYVA: is the file complete?");
  return cams;
}

std::string member(const std::string& name, const std::string& value) {
  return "<value member=\"" + name + "\"><simpleValue value=\"" + value + "\"/></value>";
}

std::string plcopen_text(const TableFile& file) {
  const Columns& c = file.table.columns();
  const std::array columns{&c.x, &c.p, &c.v, &c.a};
  std::string points;
  for (std::size_t knot = 0; knot < c.x.size(); ++knot) {
    points += "      <value><structValue>";
    for (std::size_t i = 0; i < columns.size(); ++i)
      points += member(std::string(cam_xyva.fields[i]), real_literal((*columns[i])[knot]));
    points += "</structValue></value>\n";
  }
  const std::string scaling = "<scaling x=\"1\" y=\"1\"/>";
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!--\n// a cam for CODESYS SoftMotion, by " +
         made_by() + "\n" + notes_text(file, "//") + coupling_calls(file) +
         "-->\n<project xmlns=\"http://www.plcopen.org/xml/tc6_0200\">\n"
         " <fileHeader companyName=\"\" productName=\"Jounce\" productVersion=\"" +
         made_by() +
         "\" creationDateTime=\"2000-01-01T00:00:00\"/>\n <contentHeader name=\"Cam\">"
         "<coordinateInfo><fbd>" +
         scaling + "</fbd><ld>" + scaling + "</ld><sfc>" + scaling +
         "</sfc></coordinateInfo></contentHeader>\n <types><dataTypes/><pous/></types>\n"
         " <instances><configurations/></instances>\n <addData><data name=\"" +
         list_of_globals +
         "\" handleUnknown=\"implementation\">\n  <globalVars name=\"CamTable\">\n"
         "   <variable name=\"CamPoints\">\n    <type><array><dimension lower=\"0\" upper=\"" +
         std::to_string(c.x.size() - 1) + "\"/><baseType><derived name=\"" +
         std::string(cam_xyva.name) +
         "\"/></baseType></array></type>\n    <initialValue><arrayValue>\n" + points +
         "    </arrayValue></initialValue>\n   </variable>\n   <variable name=\"Cam\">\n"
         "    <type><derived name=\"MC_CAM_REF\"/></type>\n    <initialValue><structValue>" +
         member("byType", "3") + member("nElements", std::to_string(c.x.size())) +
         member("xStart", real_literal(c.x.front())) + member("xEnd", real_literal(c.x.back())) +
         "</structValue></initialValue>\n   </variable>\n  </globalVars>\n </data></addData>\n"
         "</project>\n";
}

}  // namespace

constinit const FormatRow plcopen_format{
    .format = {.name = "plcopen",
               .maker = "CODESYS SoftMotion, list of global variables as PLCopen XML",
               .knot = "a value `SMC_CAMXYVA` of an array of a list of global variables, with its "
                       "`MC_CAM_REF`",
               .source = "PLCopen TC6 XML 2.01; CODESYS, Import PLCopenXML; public exports",
               .extension = ".xml",
               .join = KnotJoin::quintic,
               .keeps_notes = true,
               .most = 32767,
               .limits_from = "nElements is an INT"},
    .detects =
        [](const std::string& text) {
          return text.find("http://www.plcopen.org/xml/tc6") != text.npos &&
                 lower(text).find("smc_camxyva") != text.npos;
        },
    .read = read_plcopen,
    .write = plcopen_text};

}  // namespace jounce::controllers_detail
