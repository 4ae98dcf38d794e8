#include "tests/three_mf/three_mf_package.h"

#include <zlib.h>

#include <cstdint>
#include <vector>

namespace hsr::test {

namespace {

void add_number(std::string& bytes, std::uint64_t number, int size) {
  for (int k = 0; k < size; ++k) bytes += static_cast<char>(number >> (8 * k) & 255U);
}

struct Entry {
  std::string name, bytes;
};

/// What a file's own head and its entry in the directory have in common.
std::string head_of(const Entry& entry) {
  std::string head;
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(entry.bytes.data()), static_cast<uInt>(entry.bytes.size()));
  add_number(head, 20, 2);    // version
  add_number(head, 0, 2);     // flags
  add_number(head, 0, 2);     // stored
  add_number(head, 0, 2);     // time
  add_number(head, 0x21, 2);  // date
  add_number(head, sum, 4);
  add_number(head, entry.bytes.size(), 4);
  add_number(head, entry.bytes.size(), 4);
  add_number(head, entry.name.size(), 2);
  add_number(head, 0, 2);  // more fields
  return head;
}

std::string zip(const std::vector<Entry>& entries) {
  std::string all, directory;
  for (const Entry& entry : entries) {
    const std::string head = head_of(entry);
    directory += "PK\x01\x02";
    add_number(directory, 20, 2);
    directory += head;
    add_number(directory, 0, 2);  // comment
    add_number(directory, 0, 2);  // disk
    add_number(directory, 0, 2);
    add_number(directory, 0, 4);
    add_number(directory, all.size(), 4);
    directory += entry.name;
    all += "PK\x03\x04" + head + entry.name + entry.bytes;
  }
  std::string end = "PK\x05\x06";
  add_number(end, 0, 4);
  add_number(end, entries.size(), 2);
  add_number(end, entries.size(), 2);
  add_number(end, directory.size(), 4);
  add_number(end, all.size(), 4);
  add_number(end, 0, 2);
  return all + directory + end;
}

}  // namespace

std::string three_mf_package(const std::string& model, const std::string& unit) {
  const std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  return zip(
      {{"[Content_Types].xml",
        xml + "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default Extension=\"rels\" "
              "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"model\" "
              "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
       {"_rels/.rels",
        xml + "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
              "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
              "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
       {"3D/3dmodel.model", xml + "<model unit=\"" + unit +
                                "\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
                                "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">" +
                                model + "</model>"}});
}

std::string tetrahedron(int number, double size, const std::string& attributes, const std::string& of_triangle) {
  const std::string s = std::to_string(size);
  return "<object id=\"" + std::to_string(number) + "\" " + attributes +
         "><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"" + s + "\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"" + s +
         "\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"" + s +
         "\"/></vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle "
         "v1=\"0\" "
         "v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\" " +
         of_triangle + "/></triangles></mesh></object>";
}

}  // namespace hsr::test
