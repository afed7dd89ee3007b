// SPDX-License-Identifier: GPL-3.0-or-later
// Forms of one table: as spreadsheets of several countries, ImageJ and numpy write it.
#include "base/csv/csv_table.h"

#include <gtest/gtest.h>

#include "base/csv/csv_record.h"
#include "base/csv/csv_units.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

CsvTable read(const std::string& text) {
  const TestFolder folder;
  return read_csv(folder.write("t.csv", text));
}

/// Two columns, v and d, with rows 1.8, 66.4 and 2.25, 1063.85.
void expect_the_table(const std::string& text) {
  SCOPED_TRACE(text);
  const CsvTable t = read(text);
  ASSERT_EQ(t.rows.size(), 2U);
  ASSERT_GE(t.columns.size(), 2U);
  EXPECT_EQ(t.columns[0], "v");
  EXPECT_EQ(t.columns[1], "d");
  EXPECT_EQ(t.number(t.rows[0], 0), 1.8);
  EXPECT_EQ(t.number(t.rows[0], 1), 66.4);
  EXPECT_EQ(t.number(t.rows[1], 0), 2.25);
  EXPECT_EQ(t.number(t.rows[1], 1), 1063.85);
}

TEST(CsvTable, FormsOfOneTable) {
  for (const char* text : {
           "v,d\n1.8,66.4\n2.25,1063.85\n",
           "v;d\n1,8;66,4\n2,25;1063,85\n",      // decimal commas
           "v;d\n1.8;66.4\n2.25;1063.85\n",      // decimal points
           "v\td\n1,8\t66,4\n2,25\t1.063,85\n",  // pasted, grouped
           "v\td\n1.8\t66.4\n2.25\t1,063.85\n",
           "v|d\n1.8|66.4\n2.25|1063.85\n",
           "v d\n 1.8   66.4\n2.25 1063.85 \n",               // columns of blanks
           "v,d\n1.8,66.4\n2.25,\"1,063.85\"\n",              // grouped in quotes
           "v,d\n\"1,8\",\"66,4\"\n\"2,25\",\"1 063,85\"\n",  // German, commas between
           "v,d\n1.8,66.4\n2.25,1063.85\n,\n,\n",             // empty rows below
           "v;d\n1.8;66.4\n2.25;1'063.85\n",                  // Swiss
           "v;d\n1,8;66,4\n2,25;1\u00A0063,85\n",             // French: a no-break space
           "v;d\n1,8;66,4\n2,25;1\u202F063,85\n",
           "v,d\n1.8E+00,6.64e1\n2.25,1.06385e+03\n",
           "v;d\n1,8E+00;6,64e1\n2,25;1,06385e3\n",
           "sep=,\nv,d\n1.8,66.4\n2.25,1063.85\n",
           "sep=;\r\nv;d\r\n1,8;66,4\r\n2,25;1063,85\r\n",
           "\"sep=;\"\nv;d\n1,8;66,4\n2,25;1063,85\n",
           "\xEF\xBB\xBFsep=\t\nv\td\n1,8\t66,4\n2,25\t1063,85\n",
           "v,d\r1.8,66.4\r2.25,1063.85\r",          // old Macintosh
           "v,d\nm/s,um\n1.8,66.4\n2.25,1063.85\n",  // a row of units
           "v,d\n[m/s],[\u00B5m]\n1.8,66.4\n2.25,1063.85\n",
           "v,d\n1.8,66.4 # first, by hand\n2.25,1063.85\t# second\n",
           "v,d,who\n1.8,66.4,me # first\n2.25,1063.85,you\n",
           "v,d # measured\n1.8,66.4\n2.25,1063.85\n",
           "# v,d\n1.8,66.4\n2.25,1063.85\n",             // numpy
           "# by hand\n# v d\n1.8 66.4\n2.25 1063.85\n",  // gnuplot
           "v,d,,\n1.8,66.4,,\n2.25,1063.85,,\n,,,\n",    // cells that once held something
           "v,d\n1.8,66.4,,\n\n2.25,1063.85\n",
           "v,d\n1.8,66.4\nv,d\n2.25,1063.85\n",  // two files in one
           "v,d,\"note\nof two lines\"\n1.8,66.4,\"a,\nb\"\n2.25,1063.85,\n",
           "v,d\n\"1.8\",\"66.4\"\n\"2.25\",\"1063.85\"\n",
           "v;d;a note, with comma\n1.8;66.4;a,b\n2.25;1063.85;c,d\n",
       })
    expect_the_table(text);
}

TEST(CsvTable, LabelsWithHashesStay) {
  const CsvTable t = read("Label,Area\nfield #3,400\nfield #4,100\n");
  EXPECT_EQ(t.rows[1].cells[0], "field #4");
  EXPECT_EQ(t.number(t.rows[1], 1), 100.0);
}

/// What one cell leaves open the column decides, then the other columns.
TEST(CsvTable, MarksOfThousandsAreToldByTheRest) {
  const auto first = [](const std::string& text) {
    const CsvTable t = read(text);
    return t.number(t.rows[0], 0);
  };
  EXPECT_EQ(first("a;b\n1.399;0,912\n"), 1399.0);
  EXPECT_EQ(first("a;b\n1.399;1\n1.234.567;1\n"), 1399.0);
  EXPECT_EQ(first("a;b\n1.399;0.912\n"), 1.399);
  EXPECT_EQ(first("a;b\n1.399;1\n"), 1.399);  // as any program would write it
  EXPECT_EQ(first("a;b\n1,399;1\n"), 1.399);
  EXPECT_EQ(first("a\tb\n1,399\t0.912\n"), 1399.0);
  EXPECT_EQ(first("a,b\n\"1,399\",0.912\n"), 1399.0);
  EXPECT_EQ(first("a;b\n0,399;1\n"), 0.399);
  EXPECT_EQ(first("a;b\n\u22121,5;1\n"), -1.5);
}

TEST(CsvTable, WhatIsOpenIsRefusedWithTheCure) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& fragments) {
    const CsvTable t = read(text);
    expect_refusal(
        [&] {
          for (const CsvTable::Row& row : t.rows) t.number(row, 0);
        },
        fragments);
  };
  // Commas in quotes are decimal where any of them is; points beside them would part thousands.
  const CsvTable quoted = read("a,b\n\"165,210\",\"0,919\"\n\"1,399\",\"0,9\"\n");
  EXPECT_EQ(quoted.number(quoted.rows[0], 0), 165.21);
  EXPECT_EQ(quoted.number(quoted.rows[1], 0), 1.399);
  refused("a,b\n1.399,\"0,919\"\n", {"line 2, column 'a'", "'1.399'", "one meaning"});
  refused("a\tb\n1,399\t1\n", {"line 2, column 'a'", "'1,399'", "one meaning"});
  refused("a;b\n1,8;1\n2;1\n1.75;1\n", {"lines 4 and 2, column 'a'", "'1.75' and '1,8'"});
  refused("a;b\nx;1\n2;1\n-;1\n;1\n", {"line 2, column 'a'", "'x'", "lines 4, 5"});
  refused("a,b\n1.8 um,1\n", {"'1.8 um'"});
  refused("a,b\n1.2.3,1\n", {"'1.2.3'"});
}

TEST(CsvTable, LinesThatDoNotFitAreNamedAtOnce) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& fragments) {
    expect_refusal([&] { read(text); }, fragments);
  };
  refused("v,d\n1,8,66,4\n2.3,60\n2,3,60,1\n",
          {"line 2, column 3", "4 cells", "line 4", "decimal commas", "semicolons"});
  refused("Drops of May\nv,d\n1,2\n", {"line 2", "title", "'#'"});
  refused("1.8,66.4\n2.3,60\n", {"line 1, header", "numbers", "names of the columns"});
  refused("v,d\nm/s,um\n", {"a header without rows"});
  refused("v,d\n1,\"2\n3,4\n", {"line 2", "close the quotes"});
  refused("v,,\n1,2,3\n", {"column '' twice", "title above"});
}

TEST(CsvUnits, SpellingsOfOneUnit) {
  for (const char* um2 :
       {"um2", "um^2", "\u00B5m\u00B2", "\u03BCm^2", "[\u00B5m\u00B2]", "microns^2"})
    EXPECT_EQ(plain_unit(um2), "um2") << um2;
  EXPECT_EQ(plain_unit("(m s\u207B\u00B9)"), "m/s");
  EXPECT_TRUE(is_row_of_units({"", "px", "-"}));
  EXPECT_FALSE(is_row_of_units({"m", "66.4"}));
  EXPECT_FALSE(is_row_of_units({"", ""}));
}

}  // namespace
}  // namespace powderlink::analysis
