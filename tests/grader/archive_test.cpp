#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <rigor/base/file.hpp>
#include <rigor/grader/archive.hpp>
#include <rigor/grader/class_run.hpp>
#include <rigor/grader/submission.hpp>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;

struct Packed {
  std::string path, bytes;
  unsigned type = AE_IFREG;
  std::string link = "";
};
void pack(const fs::path& to, const std::vector<Packed>& files, bool zip = true) {
  ::archive* out = archive_write_new();
  if (zip) {
    archive_write_set_format_zip(out);
  } else {
    archive_write_set_format_pax_restricted(out);
    archive_write_add_filter_gzip(out);
  }
  ASSERT_EQ(archive_write_open_filename(out, to.c_str()), ARCHIVE_OK);
  for (const Packed& file : files) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, file.path.c_str());
    archive_entry_set_filetype(entry, file.type);
    archive_entry_set_perm(entry, 0644);
    archive_entry_set_size(entry, la_int64_t(file.bytes.size()));
    if (file.type == AE_IFLNK) archive_entry_set_symlink(entry, file.link.c_str());
    ASSERT_EQ(archive_write_header(out, entry), ARCHIVE_OK) << archive_error_string(out);
    archive_write_data(out, file.bytes.data(), file.bytes.size());
    archive_entry_free(entry);
  }
  archive_write_free(out);
}
std::string sample(const std::string& file) { return *read_file(fs::path(RIGOR_SOURCE_DIR) / "tests/submissions/right/expressions" / file); }
bool noted(const std::vector<std::string>& notes, const std::string& part) {
  for (const std::string& note : notes)
    if (note.find(part) != std::string::npos) return true;
  return false;
}

class ArchivedSubmission : public ::testing::Test {
 protected:
  void SetUp() override {
    root = fs::temp_directory_path() / ("rigor-archive-test-" + std::to_string(::getpid()));
    fs::remove_all(root);
    fs::create_directories(root / "in");
  }
  void TearDown() override { fs::remove_all(root); }
  std::vector<Packed> good(const std::string& below = "") {
    std::vector<Packed> files;
    for (const auto& item : fs::directory_iterator(fs::path(RIGOR_SOURCE_DIR) / "tests/submissions/right/expressions"))
      if (item.is_regular_file()) files.push_back({below + item.path().filename().string(), *read_file(item.path())});
    return files;
  }
  fs::path root;
};

// One rule for every way of handing in: the same files are the same submission.
TEST_F(ArchivedSubmission, HasTheHashOfTheSameFilesInADirectory) {
  const auto plain = open_submission(fs::path(RIGOR_SOURCE_DIR) / "tests/submissions/right/expressions");
  ASSERT_TRUE(plain);
  for (const bool zip : {true, false}) {
    const fs::path file = root / (zip ? "ada.zip" : "ada.tar.gz");
    pack(file, good(), zip);
    const auto packed = open_submission(file);
    ASSERT_TRUE(packed) << packed.fault().text();
    EXPECT_EQ(packed->hash, plain->hash);
    EXPECT_EQ(packed->files.size(), plain->files.size());
  }
}

TEST_F(ArchivedSubmission, LeavesAsideWhatLeadsOutOfItWithANote) {
  auto files = good("work/");
  files.push_back({"../../etc/Cuboid.cpp", "evil"});
  files.push_back({"/tmp/CollisionPlane.cpp", "evil"});
  files.push_back({"a/../../MatrixUtils.cpp", "evil"});
  files.push_back({"work/link.cpp", "", AE_IFLNK, "/etc/passwd"});
  files.push_back({"__MACOSX/Cuboid.cpp", "resource fork"});
  files.push_back({"work/two\nlines \"and\" <b>.cpp", "int x;"});
  const fs::path file = root / "evil.zip";
  pack(file, files);
  const auto packed = open_submission(file);
  ASSERT_TRUE(packed) << packed.fault().text();
  EXPECT_EQ(packed->find("Cuboid.cpp")->text, sample("Cuboid.cpp"));
  for (const char* part : {"etc/Cuboid.cpp: not used, its path leads out", "tmp/CollisionPlane.cpp: not used", "a/../../MatrixUtils.cpp: not used", "link.cpp: a link"})
    EXPECT_TRUE(noted(packed->notes, part)) << part;
  for (const std::string& note : packed->notes) EXPECT_EQ(note.find('\n'), std::string::npos);
  EXPECT_FALSE(fs::exists("/tmp/CollisionPlane.cpp"));
}

TEST_F(ArchivedSubmission, IsNotReadToItsEndWhenItIsABomb) {
  std::vector<Packed> many = good();
  for (int k = 0; k < 70; ++k) many.push_back({"pad" + std::to_string(k) + ".h", std::string(1u << 20, ' ')});
  pack(root / "bomb.zip", many);
  EXPECT_LT(fs::file_size(root / "bomb.zip"), 1u << 20) << "70 MiB in less than one";
  EXPECT_EQ(open_submission(root / "bomb.zip").fault().kind, Fault::Kind::out_of_range);

  pack(root / "one.zip", {{"Cuboid.cpp", std::string(40u << 20, 'x')}});
  const auto one = open_submission(root / "one.zip");
  ASSERT_FALSE(one);
  EXPECT_EQ(one.fault().kind, Fault::Kind::out_of_range);
  pack(root / "two.zip", {{"Cuboid.cpp", std::string(2u << 20, 'x')}});
  EXPECT_EQ(open_submission(root / "two.zip").fault().kind, Fault::Kind::missing) << "a file of 2 MiB is left aside, and nothing is left";

  ArchiveLimits few;
  few.entries = 3;
  EXPECT_EQ(read_archive(root / "bomb.zip", few).fault().kind, Fault::Kind::out_of_range);
  few = {};
  few.packed_bytes = 100;
  EXPECT_EQ(read_archive(root / "bomb.zip", few).fault().kind, Fault::Kind::out_of_range);
}

TEST_F(ArchivedSubmission, SaysWhenItIsNoArchiveOrDamaged) {
  EXPECT_TRUE(write_file(root / "text.zip", "this is no archive"));
  EXPECT_EQ(open_submission(root / "text.zip").fault().kind, Fault::Kind::malformed);
  pack(root / "cut.tar.gz", good(), false);
  const std::string bytes = *read_file(root / "cut.tar.gz");
  EXPECT_TRUE(write_file(root / "cut.tar.gz", bytes.substr(0, bytes.size() / 2)));
  EXPECT_EQ(open_submission(root / "cut.tar.gz").fault().kind, Fault::Kind::malformed);
  EXPECT_TRUE(write_file(root / "note.txt", "x"));
  EXPECT_EQ(open_submission(root / "note.txt").fault().kind, Fault::Kind::unreadable);
}

// Every byte of an archive may be hostile: whatever comes, an answer and no crash.
TEST_F(ArchivedSubmission, AnswersWhateverByteIsChanged) {
  pack(root / "a.zip", good());
  const std::string bytes = *read_file(root / "a.zip");
  std::uint64_t random = 88172645463325252u;
  for (int k = 0; k < 300; ++k) {
    std::string changed = bytes;
    for (int n = 0; n < 1 + k % 4; ++n) {
      random ^= random << 13, random ^= random >> 7, random ^= random << 17;
      changed[random % changed.size()] = char(random >> 32);
    }
    EXPECT_TRUE(write_file(root / "changed.zip", changed));
    const auto read = read_archive(root / "changed.zip");
    if (!read) {
      EXPECT_TRUE(read.fault().kind == Fault::Kind::malformed || read.fault().kind == Fault::Kind::out_of_range);
    }
  }
}

TEST_F(ArchivedSubmission, OfAClassIsReadInEveryLayout) {
  pack(root / "in" / "ada@x.edu_3_handin.zip", good());
  pack(root / "in" / "ada@x.edu_12_handin.tar.gz", good("late/"), false);
  for (const char* file : {"Cuboid.cpp", "CollisionPlane.cpp"}) {
    EXPECT_TRUE(write_file(root / "in" / (std::string("lovelaceada_LATE_77_12_") + file), sample(file)));
  }
  EXPECT_TRUE(write_file(root / "in" / "lovelaceada_LATE_77_14_ParticleSystem-1.cpp", sample("ParticleSystem.cpp")));
  fs::create_directories(root / "in" / "Grace Hopper_4711_assignsubmission_file_");
  EXPECT_TRUE(write_file(root / "in" / "readme.txt", "not a submission"));
  const auto roster = read_roster(root / "in");
  ASSERT_TRUE(roster);
  ASSERT_EQ(roster->size(), 3u);
  EXPECT_EQ((*roster)[0].student, "Grace Hopper_4711") << "two may have one name";
  EXPECT_EQ((*roster)[1].student, "ada@x.edu");
  EXPECT_EQ((*roster)[1].version, 12);
  EXPECT_EQ((*roster)[2].student, "lovelaceada_77");
  EXPECT_TRUE((*roster)[2].late);
  ASSERT_EQ((*roster)[2].uploads.size(), 3u);
  const auto submission = open_submission((*roster)[2].uploads);
  ASSERT_TRUE(submission) << submission.fault().text();
  for (const char* file : {"Cuboid.cpp", "CollisionPlane.cpp", "ParticleSystem.cpp"}) EXPECT_NE(submission->find(file), nullptr) << file;

  // the same class as one file, as Canvas hands it out
  std::vector<Packed> all;
  for (const auto& item : fs::directory_iterator(root / "in"))
    if (item.is_regular_file()) all.push_back({item.path().filename().string(), *read_file(item.path())});
  pack(root / "class.zip", all);
  ASSERT_TRUE(unpack_class(root / "class.zip", root / "unpacked"));
  EXPECT_EQ(read_roster(root / "unpacked")->size(), 2u);
}

TEST_F(ArchivedSubmission, PackedOnWindowsHasItsOwnPathSeparator) {
  pack(root / "a.zip", {{"Assignment\\Cuboid.cpp", "int a;"}, {"Assignment\\..\\..\\CollisionPlane.cpp", "x"}, {"C:\\MatrixUtils.cpp", "x"}});
  const auto s = open_submission(root / "a.zip");
  ASSERT_TRUE(s) << s.fault().text();
  EXPECT_NE(s->find("Cuboid.cpp"), nullptr);
  EXPECT_EQ(s->files.size(), 1u);
  EXPECT_TRUE(noted(s->notes, "CollisionPlane.cpp: not used, its path leads out"));
}

TEST_F(ArchivedSubmission, AloneInAFolderStandsForIt) {
  fs::create_directories(root / "in" / "ada");
  pack(root / "in" / "ada" / "work.zip", good("work/"));
  EXPECT_TRUE(write_file(root / "in" / "ada" / "readme.txt", "x"));
  const auto s = open_submission(root / "in" / "ada");
  ASSERT_TRUE(s) << s.fault().text();
  EXPECT_EQ(s->name, "ada");
  EXPECT_TRUE(noted(s->notes, "unpacked from work.zip"));
}

// A member that is passed by is unpacked all the same where the whole tar is one compressed stream.
TEST_F(ArchivedSubmission, IsRefusedForWhatItWouldOnlyPassBy) {
  auto files = good();
  files.push_back({"film.bin", std::string(32u << 20, '\0')});
  for (const bool zip : {true, false}) {
    pack(root / "bomb", files, zip);
    fs::rename(root / "bomb", root / "bomb.zip");
    const auto s = open_submission(root / "bomb.zip");
    ASSERT_FALSE(s);
    EXPECT_EQ(s.fault().kind, Fault::Kind::out_of_range);
    EXPECT_NE(s.fault().text().find("more than 200 times its size"), std::string::npos) << s.fault().text();
  }
}

TEST_F(ArchivedSubmission, OfAClassMayBeWrappedInOneDirectoryAndLooseFromAutolab) {
  pack(root / "class.zip", {{"submissions/bob@x.edu_1_Cuboid.cpp", "int a;"}, {"submissions/ada/Cuboid.cpp", "x"}, {"submissions/eve/Cuboid.cpp", "x"}});
  const auto place = unpack_class(root / "class.zip", root / "unpacked");
  ASSERT_TRUE(place);
  const auto roster = read_roster(*place);
  ASSERT_TRUE(roster);
  ASSERT_EQ(roster->size(), 3u);
  EXPECT_EQ((*roster)[1].student, "bob@x.edu");
  const auto bob = open_submission((*roster)[1].uploads);
  ASSERT_TRUE(bob) << bob.fault().text();
  EXPECT_NE(bob->find("Cuboid.cpp"), nullptr);
}

ClassRow graded(const std::string& student, double score, std::map<std::string, std::string> verdicts = {}) {
  ClassRow row;
  row.entry.student = student;
  row.score = score;
  row.max_score = 100;
  row.verdicts = std::move(verdicts);
  row.rubric_hash = "r1";
  return row;
}

TEST_F(ArchivedSubmission, GradebooksAreFilledInAndNothingElseChanges) {
  std::vector<ClassRow> rows{graded("ada@x.edu", 87.5), graded("lovelaceada_77", 100)};
  rows[1].entry.people = {{.canvas_id = "77"}};
  const std::string canvas = "Student,ID,SIS Login ID,Section,Rigid (12)\n    Points Possible,,,,100\n\"Lovelace, Ada\",77,ada2,\"A \"\"1\"\"\",\nNobody,78,nobody,B,3\n";
  EXPECT_TRUE(write_file(root / "canvas.csv", canvas));
  const auto filled = fill_gradebook(root / "canvas.csv", "Rigid (12)", rows);
  ASSERT_TRUE(filled) << filled.fault().text();
  EXPECT_EQ(filled->csv, "Student,ID,SIS Login ID,Section,Rigid (12)\n    Points Possible,,,,100\n\"Lovelace, Ada\",77,ada2,\"A \"\"1\"\"\",100\nNobody,78,nobody,B,3\n");
  EXPECT_EQ(filled->filled, 1);
  EXPECT_EQ(filled->rows, 2) << "points possible are no student";
  EXPECT_EQ(filled->remarks, (std::vector<std::string>{"ada@x.edu: 87.5 points; no row of the gradebook is this student's",
                                                       "Nobody (nobody): not filled in, nobody's submission; keeps 3"}));

  EXPECT_TRUE(write_file(root / "moodle.csv", "Identifier,Full name,Email address,Grade\nParticipant 1,Ada,ada@x.edu,\n"));
  EXPECT_EQ(fill_gradebook(root / "moodle.csv", "", rows)->csv, "Identifier,Full name,Email address,Grade\nParticipant 1,Ada,ada@x.edu,87.5\n");
  EXPECT_TRUE(write_file(root / "autolab.csv", "ada@x.edu,0\nbob@x.edu,5\n"));
  EXPECT_EQ(fill_gradebook(root / "autolab.csv", "", rows)->csv, "ada@x.edu,87.5\nbob@x.edu,5\n");

  const auto wrong = fill_gradebook(root / "canvas.csv", "Rigid (13)", rows);
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.fault().text().find("did you mean 'Rigid (12)'?"), std::string::npos) << wrong.fault().text();
  EXPECT_TRUE(write_file(root / "broken.csv", "ID,Grade\n\"77,3\n"));
  EXPECT_EQ(fill_gradebook(root / "broken.csv", "", rows).fault().kind, Fault::Kind::malformed);
}

// Byte for byte but for the points: mark, line ends, quotes, and cells of several lines, as the platform wrote them.
TEST_F(ArchivedSubmission, GradebooksKeepTheirMarkLineEndsAndQuotes) {
  ClassRow ada = graded("Ada_1", 87.5), bob = graded("Bob_2", 70), eve = graded("Eve_3", 5);
  ada.entry.people = {{.name = "Ada", .participant = "1"}};
  bob.entry.people = {{.name = "Bob", .participant = "2"}};
  eve.entry.people = {{.name = "Eve", .participant = "3"}};
  const std::string before = "\xef\xbb\xbfIdentifier,\"Full name\",Note,Grade,Maximum Grade\r\n";
  const auto book = [&](const std::string& a, const std::string& b, const std::string& e) {
    return before + "\"Participant 1\",\"Ada\",\"two\r\nlines, \"\"quoted\"\"\"," + a + ",\"100.00\"\r\n\r\nParticipant 2,Bob, spaced ," + b + ",100\nParticipant 3,Eve" + e;
  };
  EXPECT_TRUE(write_file(root / "m.csv", book("\"\"", "\"70.00\"", "")));
  const auto filled = fill_gradebook(root / "m.csv", "", {ada, bob, eve});
  ASSERT_TRUE(filled) << filled.fault().text();
  EXPECT_EQ(filled->csv, book("87.5", "\"70.00\"", ",,5")) << "what is the same number stays as it is; a line cut short is made longer";
  EXPECT_EQ(filled->filled, 3);
  EXPECT_TRUE(write_file(root / "m.csv", "Identifier,Full name,Grade\nParticipant 1,\"Ada\nL\x1b[31m\",\n"));
  EXPECT_EQ(fill_gradebook(root / "m.csv", "", {})->remarks, std::vector<std::string>{"Ada?L?[31m (Participant 1): not filled in, nobody's submission; stays empty"}) << "a line each";
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const auto table = [&](const char* points) { return std::string("Identifier,Grade") + end + "Participant 1," + points + end; };
    EXPECT_TRUE(write_file(root / "m.csv", table("")));
    EXPECT_EQ(fill_gradebook(root / "m.csv", "", {ada})->csv, table("87.5"));
  }
}

TEST_F(ArchivedSubmission, OfMoodleMayComeWithoutFoldersAndWithTextTypedOnline) {
  for (const char* name : {"Ada Lovelace_987_assignsubmission_file_", "Ada Lovelace_987_assignsubmission_onlinetext_", "Kim Li_60_assignsubmission_onlinetext_"})
    fs::create_directories(root / "in" / name);
  for (const char* name : {"Jo Ny_70_assignsubmission_onlinetext_onlinetext.html", "Jo Ny_70_assignsubmission_file_Cuboid.cpp", "Jo Ny_70_assignsubmission_file_MatrixUtils.cpp"})
    EXPECT_TRUE(write_file(root / "in" / name, "int a;"));
  const auto roster = read_roster(root / "in");
  ASSERT_TRUE(roster);
  ASSERT_EQ(roster->size(), 3u);
  EXPECT_EQ((*roster)[0].student, "Ada Lovelace_987");
  EXPECT_EQ((*roster)[0].uploads, std::vector<fs::path>{root / "in" / "Ada Lovelace_987_assignsubmission_file_"});
  EXPECT_EQ((*roster)[0].versions, 1);
  EXPECT_EQ((*roster)[1].uploads.size(), 2u);
  EXPECT_EQ((*roster)[1].trouble, "");
  EXPECT_EQ((*roster)[1].people.at(0).participant, "70");
  const auto jo = open_submission((*roster)[1].uploads);
  ASSERT_TRUE(jo) << jo.fault().text();
  EXPECT_NE(jo->find("Cuboid.cpp"), nullptr);
  EXPECT_EQ((*roster)[2].student, "Kim Li_60");
  EXPECT_FALSE(open_submission((*roster)[2].uploads)) << "named, and why: there is no file of the assignment";
}

TEST_F(ArchivedSubmission, PointsGoToThePersonThePlatformNamesAndWhatIsWrittenOverIsSaid) {
  ClassRow bob = graded("Bob", 94);
  bob.entry.people = {{.name = "Bob", .email = "robert@uni.edu", .school_id = "11"}};
  ClassRow group = graded("Ada and Alan", 80);
  group.entry.people = {{.name = "Ada", .email = "ada@uni.edu"}, {.name = "Alan", .email = "alan@uni.edu"}};
  ClassRow broken = graded("Sam", 0);
  broken.entry.people = {{.name = "Sam", .email = "sam@uni.edu"}};
  broken.trouble = "damaged";
  EXPECT_TRUE(write_file(root / "g.csv", "Student,SIS User ID,SIS Login ID,Grade\n    Points Possible,,,50\nR,11,robert@uni.edu,60\nB,12,bob@uni.edu,77\n"
                                         "A,1,ADA@uni.edu,\nAl,2,alan@uni.edu,80.0\nS,3,sam@uni.edu,55\n"));
  const auto filled = fill_gradebook(root / "g.csv", "", {bob, group, broken});
  ASSERT_TRUE(filled);
  EXPECT_EQ(filled->csv, "Student,SIS User ID,SIS Login ID,Grade\n    Points Possible,,,50\nR,11,robert@uni.edu,94\nB,12,bob@uni.edu,77\n"
                         "A,1,ADA@uni.edu,80\nAl,2,alan@uni.edu,80.0\nS,3,sam@uni.edu,55\n");
  EXPECT_EQ(filled->remarks, (std::vector<std::string>{"the gradebook's points possible are 50, the rubric's 100: the points are filled in as they are",
                                                       "R (robert@uni.edu): 60 overwritten with 94", "B (bob@uni.edu): not filled in, nobody's submission; keeps 77",
                                                       "S (sam@uni.edu): not filled in, could not be graded (Sam); keeps 55"}));
  // the e-mail is one row's, the number another's; a plain folder is nobody's e-mail
  EXPECT_TRUE(write_file(root / "g.csv", "SIS User ID,SIS Login ID,Grade\n11,x@uni.edu,\n12,robert@uni.edu,\n"));
  const auto torn = fill_gradebook(root / "g.csv", "", {bob, graded("x", 5)});
  EXPECT_EQ(torn->filled, 0);
  EXPECT_EQ(torn->remarks.at(0), "Bob: 94 points; not filled in, several rows fit: x@uni.edu and robert@uni.edu");
  EXPECT_EQ(torn->remarks.at(1), "x: 5 points; no row of the gradebook is this student's");
  // two submissions for one row
  ClassRow twin = bob;
  twin.score = 3;
  EXPECT_TRUE(write_file(root / "g.csv", "SIS Login ID,Grade\nrobert@uni.edu,9\n"));
  EXPECT_EQ(fill_gradebook(root / "g.csv", "", {bob, twin})->csv, "SIS Login ID,Grade\nrobert@uni.edu,9\n");

  EXPECT_TRUE(write_file(root / "autolab.csv", "ada@uni.edu,0\n"));
  EXPECT_FALSE(fill_gradebook(root / "autolab.csv", "Grade", {group})) << "there is no header to find it in";
}

TEST_F(ArchivedSubmission, MoodlesWorksheetIsFilledByParticipantNumberElseByFullName) {
  for (const char* name : {"Ada Lovelace_987_assignsubmission_file_", "Pat OBrien_55_assignsubmission_file_", "Kim Li_60_assignsubmission_file_", "Jo Ny_70_assignsubmission_file_"})
    fs::create_directories(root / "in" / name);
  const auto roster = read_roster(root / "in");
  ASSERT_TRUE(roster);
  std::vector<ClassRow> rows;
  for (const Entry& entry : *roster) rows.push_back(graded(entry.student, 10 + double(rows.size()))), rows.back().entry = entry;  // Ada, Jo, Kim, Pat
  EXPECT_TRUE(write_file(root / "m.csv", "Identifier,Full name,Email address,Grade,Maximum Grade\nParticipant 1987,Eve,e@x,,100\nParticipant 987,Ada Lovelace,a@x,,100\n"
                                         "Teilnehmer/in55,Pat O'Brien,p@x,,100\nParticipant 61,Kim Li,k@x,,100\nParticipant 70,Somebody Else,s@x,5,100\n"));
  const auto filled = fill_gradebook(root / "m.csv", "", rows);
  ASSERT_TRUE(filled);
  EXPECT_EQ(filled->csv, "Identifier,Full name,Email address,Grade,Maximum Grade\nParticipant 1987,Eve,e@x,,100\nParticipant 987,Ada Lovelace,a@x,10,100\n"
                         "Teilnehmer/in55,Pat O'Brien,p@x,13,100\nParticipant 61,Kim Li,k@x,12,100\nParticipant 70,Somebody Else,s@x,5,100\n");
  EXPECT_TRUE(write_file(root / "m.csv", "Identifier,Full name,Grade,Maximum Grade\nParticipant 1,Kim Li,,50\nParticipant 2,Kim Li,,50\n"));
  const auto twice = fill_gradebook(root / "m.csv", "", rows);
  EXPECT_EQ(twice->filled, 0) << "a name that is there twice says nothing";
  EXPECT_EQ(twice->remarks.back(), "the gradebook's maximum grade is 50, the rubric's 100: the points are filled in as they are");
}

TEST(Changes, SayWhoIsNewAndWhoIsGone) {
  ClassRow broken = graded("broken", 0);
  broken.trouble = "damaged";
  const auto list = changes({graded("tony", 55, {{"force.sum", "fail"}})}, {graded("ada", 90, {{"force.sum", "pass"}, {"moi.body", "pass"}}), broken});
  EXPECT_EQ(changes_csv(list), "student,before,after,why\nada,,90,new: no report in the earlier run\ntony,55,,\"gone: graded in the earlier run, no submission now\"\n");
}

TEST(Changes, NameWhatMovedAndWhy) {
  ClassRow before = graded("ada", 90, {{"force.sum", "fail"}}), after = graded("ada", 100, {{"force.sum", "pass"}});
  after.rubric_hash = "r2";
  const auto list = changes({before, graded("same", 5)}, {after, graded("same", 5)});
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].why, "other rubric; force.sum fail -> pass");
  EXPECT_EQ(changes_csv(list), "student,before,after,why\nada,90,100,other rubric; force.sum fail -> pass\n");
}

}  // namespace
}  // namespace rigor::grader
