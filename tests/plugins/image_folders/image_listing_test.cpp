// SPDX-License-Identifier: BSD-3-Clause
// Images of a folder, and pairs of images.
#include "image_listing.hpp"

#include <catch2/catch.hpp>

#include "data_folder.hpp"

namespace tolman::image_folders {

TEST_CASE("a folder's images, and only they") {
  const DataFolder data;
  for (const char* name :
       {"x/10.png", "x/9.JPG", "x/8.jpeg", "x/notes.txt", "x/11.bmp", "x/._10.png"}) {
    data.write(name, "");
  }
  Inspection inspection;
  std::string names;
  for (const auto& file : listImages(data.path("x"), inspection)) {
    names += file.filename().string() + " ";
  }
  CHECK(names == "8.jpeg 9.JPG 10.png ");
  CHECK_FALSE(inspection.hasErrors());
}

TEST_CASE("hidden images are frames if their names are numbers, otherwise one warning") {
  const DataFolder data;
  for (const char* name : {"1.0", "1.1", ".8", ".9", ".25", "._1.0"}) {
    data.write(std::string("x/") + name + ".png", "");
  }
  data.write("x/.notes.txt", "");
  const auto namesOf = [&](Inspection& inspection) {
    std::string names;
    for (const auto& file : listImages(data.path("x"), inspection)) {
      names += file.stem().string() + " ";
    }
    return names;
  };
  Inspection numbers;
  CHECK(namesOf(numbers) == ".25 .8 .9 1.0 1.1 ");  // by value, so in doubt: .25 may follow .9
  REQUIRE(numbers.findings().size() == 1);
  CHECK(numbers.findings()[0].message.starts_with("has names whose order is in doubt: .25.png"));
  data.remove("x/.25.png");
  data.write("x/.cover.png", "");
  Inspection one;
  CHECK(namesOf(one) == ".8 .9 1.0 1.1 ");
  REQUIRE(one.findings().size() == 1);
  CHECK(one.findings()[0].severity == Finding::Severity::Warning);
  CHECK(one.findings()[0].message ==
        "has the hidden image .cover.png, which is left out; if it is a frame, rename it without "
        "the point");
  data.write("x/.back.JPG", "");
  Inspection two;
  CHECK(namesOf(two) == ".8 .9 1.0 1.1 ");
  REQUIRE(two.findings().size() == 1);
  CHECK(two.findings()[0].message ==
        "has 2 hidden images, such as .back.JPG, which are left out; if they are frames, rename "
        "them without the point");
}

TEST_CASE("a gap in the numbers of evenly numbered images is one warning a folder") {
  const DataFolder data;
  const auto warnings = [&](const std::string& folder, const std::vector<int>& numbers) {
    for (const int number : numbers) {
      data.write(folder + "/f" + std::to_string(100 + number) + "_l.png", "");
    }
    Inspection inspection;
    listImages(data.path(folder), inspection);
    std::vector<std::string> found;
    for (const auto& finding : inspection.findings()) found.push_back(finding.message);
    return found;
  };
  std::vector<int> numbers;
  for (int i = 0; i < 40; i += 2) numbers.push_back(i);
  CHECK(warnings("all", numbers).empty());
  std::erase(numbers, 8);
  CHECK(warnings("gap", numbers) ==
        std::vector<std::string>{"has no image between f106_l.png and f110_l.png; times and poses "
                                 "by position are wrong from there on, unless their lines are "
                                 "missing as well"});
  CHECK(warnings("many", {1, 2, 3, 9, 10, 11, 20, 100}).size() == 1);
  CHECK(warnings("uneven", {1, 2, 4, 8, 16, 32}).empty());
  CHECK(warnings("one", {3}).empty());
}

TEST_CASE("numbers that differ in leading zeros are two frames, with one warning a folder") {
  const DataFolder data;
  for (const char* name : {"1.png", "01.png", "2.png", "02.png", "3.png"}) {
    data.write(std::string("x/") + name, "");
    data.write(std::string("y/a") + name, "");
  }
  data.write("z/0.png", "");
  data.write("z/10.png", "");
  for (const auto& [folder, warning] :
       {std::pair("x",
                  "has both 01.png and 1.png, which are two frames; remove one if they are "
                  "one image"),
        std::pair("y",
                  "has both a01.png and a1.png, which are two frames; remove one if they are "
                  "one image"),
        std::pair("z", "")}) {
    Inspection inspection;
    const auto images = listImages(data.path(folder), inspection);
    CHECK(images.size() == (*warning == 0 ? 2 : 5));
    CHECK_FALSE(inspection.hasErrors());
    CHECK(inspection.status().isOk());
    REQUIRE(inspection.findings().size() == (*warning == 0 ? 0 : 1));
    if (*warning == 0) continue;
    CHECK(inspection.findings()[0].severity == Finding::Severity::Warning);
    CHECK(inspection.findings()[0].where == data.path(folder).string());
    CHECK(inspection.findings()[0].message == warning);
  }
}

TEST_CASE("names that are times are in the order of the times, with a warning") {
  const DataFolder data;
  for (const char* name : {"0.95", "1.0", "1.05", "1.1", "1.15", "1.2"}) {
    data.write(std::string("x/") + name + ".png", "");
    data.write(std::string("same/") + name + (name[3] == 0 ? "0.png" : ".png"), "");
  }
  const auto names = [&](const std::string& folder, Inspection& inspection) {
    std::string all;
    for (const auto& file : listImages(data.path(folder), inspection)) {
      all += file.stem().string() + " ";
    }
    return all;
  };
  Inspection inspection;
  CHECK(names("x", inspection) == "0.95 1.0 1.05 1.1 1.15 1.2 ");
  REQUIRE(inspection.findings().size() == 1);
  CHECK(inspection.findings()[0].severity == Finding::Severity::Warning);
  CHECK(inspection.findings()[0].message ==
        "has names whose order is in doubt: 1.05.png is read before 1.1.png, by their numbers with "
        "sign and decimals; rename the images to numbers of equally many digits without sign, or, "
        "if the names are times, set stamps_in_names (of `images`)");
  Inspection without_doubt;
  CHECK(names("same", without_doubt) == "0.95 1.00 1.05 1.10 1.15 1.20 ");
  CHECK(without_doubt.findings().empty());
}

TEST_CASE("problems of a folder") {
  const DataFolder data;
  const auto failure = [&](const std::string& name) {
    Inspection inspection;
    listImages(data.path(name), inspection);
    return data.anonymous(inspection.status().message());
  };
  CHECK(failure("nowhere") ==
        "DATA/nowhere: cannot be read (No such file or directory); check the path");
  data.write("empty/readme.txt", "");
  CHECK(failure("empty") == "DATA/empty: has no .png or .jpg images; check the path");
  data.write("twice/1.png", "");
  data.write("twice/1.jpg", "");
  CHECK(failure("twice") == "DATA/twice: has both 1.jpg and 1.png; remove one of them");
}

TEST_CASE("the warning says why the order is taken") {
  const DataFolder data;
  for (const char* name : {"1.1", "1.2", "1.9", "1.10"}) {
    data.write(std::string("x/") + name + ".png", "");
  }
  for (const char* name : {"08", "09", "0a", "10"})
    data.write(std::string("y/") + name + ".jpg", "");
  const auto warning = [&](const std::string& folder) {
    Inspection inspection;
    listImages(data.path(folder), inspection);
    REQUIRE(inspection.findings().size() == 1);
    return inspection.findings()[0].message;
  };
  CHECK(warning("x") ==
        "has names whose order is in doubt: 1.2.png is read before 1.10.png, digits as whole "
        "numbers, because 1.1.png and 1.10.png are equal otherwise; rename the images to numbers "
        "of equally many digits without sign, or, if the names are times, set stamps_in_names (of "
        "`images`)");
  CHECK(warning("y") ==
        "has names whose order is in doubt: 08.jpg is read before 0a.jpg, as hexadecimal numbers; "
        "rename the images to decimal ones");
}

TEST_CASE("an image that is named unlike most is a frame, with a warning") {
  const DataFolder data;
  const auto warnings = [&] {
    Inspection inspection;
    CHECK_FALSE(listImages(data.path("x"), inspection).empty());
    std::vector<std::string> found;
    for (const auto& finding : inspection.findings()) found.push_back(finding.message);
    return found;
  };
  for (const char* name : {"1", "2", "3", "thumb"})
    data.write(std::string("x/") + name + ".png", "");
  CHECK(warnings() == std::vector<std::string>{"has thumb.png, which is named unlike most images "
                                               "and a frame as well; remove it if it is none"});
  data.write("x/5.png", "");
  CHECK(warnings().size() == 2);  // the gap as well
  data.remove("x/5.png");
  data.write("x/cover.png", "");
  CHECK(warnings() ==
        std::vector<std::string>{"has cover.png and other images, 2 in all, which are named unlike "
                                 "most and frames as well; remove those that are none"});
}

TEST_CASE("partners are in the order of the left images, whatever that is") {
  const DataFolder data;
  for (const char* name : {"1.05.png", "1.1.jpg", "1.10.png", "9.png", "10.png"}) {
    data.write(std::string("r/") + name, "");
  }
  Inspection inspection;
  const std::vector<std::filesystem::path> left = {"l/10.jpg", "l/1.10.png", "l/9.png",
                                                   "l/1.05.png", "l/1.1.png"};
  std::string names;
  for (const auto& file : listPartners(left, data.path("r"), inspection)) {
    names += file.filename().string() + " ";
  }
  CHECK(names == "10.png 1.10.png 9.png 1.05.png 1.1.jpg ");
  CHECK(inspection.findings().empty());
}

TEST_CASE("images without a partner are named, on either side") {
  const DataFolder data;
  for (const char* name : {"2.jpg", "3.png", "10.png"}) {
    data.write(std::string("d/image_1/") + name, "");
  }
  Inspection inspection;
  const auto image = [&](const char* name) { return data.path("d/image_0") / name; };
  const auto right = listPartners({image("1.png"), image("2.png"), image("10.png")},
                                  data.path("d/image_1"), inspection);
  CHECK(right.size() == 3);
  REQUIRE(inspection.findings().size() == 2);
  CHECK(data.anonymous(inspection.findings()[0].where) == "DATA/d/image_1");
  CHECK(inspection.findings()[0].message ==
        "has no 1, the partner of image_0/1.png; restore it, or remove the partner");
  CHECK(data.anonymous(inspection.findings()[1].where) == "DATA/d/image_0");
  CHECK(inspection.findings()[1].message ==
        "has no 3, the partner of image_1/3.png; restore it, or remove the partner");
}

}  // namespace tolman::image_folders
