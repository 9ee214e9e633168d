// The program as its user meets it: exit statuses, messages, files.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <rigor/base/file.hpp>
#include <rigor/cli/explain.hpp>
#include <rigor/report/wrap.hpp>
#include <set>
#include <sstream>
#include <string>
#include <tests/cli/shell.hpp>

namespace rigor {
namespace {

namespace fs = std::filesystem;

Ran rigor_says(const std::string& arguments, const std::string& before = "") { return sh(before + std::string(RIGOR_BINARY_DIR) + "/rigor " + arguments); }
bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
void expect_columns(const std::string& text, std::size_t most) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(report::columns(line), most) << line;
}
void expect_eighty_columns(const std::string& text) { expect_columns(text, 80); }

class Program : public ::testing::Test {
 protected:
  void SetUp() override {
    dir = fs::temp_directory_path() / ("rigor-program-test-" + std::to_string(::getpid()));
    fs::create_directories(dir);
  }
  void TearDown() override { fs::remove_all(dir); }
  std::string file(const std::string& name, const std::string& text) {
    EXPECT_TRUE(write_file(dir / name, text));
    return (dir / name).string();
  }
  fs::path dir;
};

TEST_F(Program, HasHelpWithAnExampleForEveryCommand) {
  const Ran top = rigor_says("--help");
  EXPECT_EQ(top.status, 0);
  for (const char* command : {"demo", "grade", "class", "audit", "run", "study", "verify", "explain", "check-table", "view", "shell"}) {
    EXPECT_TRUE(contains(top.text, command));
    const Ran help = rigor_says(std::string(command) + " --help");
    EXPECT_EQ(help.status, 0) << command;
    EXPECT_TRUE(contains(help.text, std::string("Example:  rigor ") + command)) << help.text;
    expect_eighty_columns(help.text);
    expect_columns(rigor_says(std::string(command) + " --help", "COLUMNS=60 ").text, 60);
  }
  expect_eighty_columns(top.text);
  for (const char* command : {"run", "view", "study"}) {
    const std::string help = rigor_says(std::string(command) + " --help").text;
    for (const char* method : {"sheet", "rk4", "split2-kahan-li8"}) EXPECT_TRUE(contains(help, method)) << command << " " << method;
  }
  const std::string study = rigor_says("study --help").text;
  for (const char* name : {"case-A", "forced", "p-01-many", "fr-04", "maps spin, aspect, mass", "cvode-adams", "exact-kicks4"}) EXPECT_TRUE(contains(study, name)) << name;
}

// What is read on a terminal is as wide as it, but for names that do not break.
TEST_F(Program, ExplainsInTheWidthOfTheTerminal) {
  const auto wide = [](const std::string& text, std::size_t columns) {
    int found = 0;
    for (std::istringstream lines(text); !lines.eof();) {
      std::string line;
      std::getline(lines, line);
      const std::size_t shown = std::size_t(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xc0) != 0x80; }));
      found += shown > columns && line.find(' ', line.find_first_not_of(" -")) != std::string::npos;
    }
    return found;
  };
  for (const char* id : {"motion.euler", "inertia.world", "impulse.normal"}) {
    const std::string narrow = rigor_says(std::string("explain ") + id, "COLUMNS=60 ").text;
    EXPECT_LE(wide(narrow, 60), 3) << narrow;
    EXPECT_GT(wide(rigor_says(std::string("explain ") + id).text, 60), 10) << id;
  }
}

TEST_F(Program, TakesHelpForTheHelpItIs) {
  EXPECT_EQ(rigor_says("help").text, rigor_says("--help").text);
  EXPECT_EQ(rigor_says("help run").text, rigor_says("run --help").text);
  EXPECT_EQ(rigor_says("help run").status, 0);
  const Ran wrong = rigor_says("help exlain");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(contains(wrong.text, "did you mean 'explain'?")) << wrong.text;
}

TEST_F(Program, SaysThatASceneStartsInsideWalls) {
  EXPECT_TRUE(contains(rigor_says("run assignment --seed 3 --until 0.1").text, "  starts inside      walls or each other: ")) << rigor_says("run assignment --seed 3 --until 0.1").text;
  for (const char* apart : {"drop", "slide", "spin-box"}) EXPECT_FALSE(contains(rigor_says(std::string("run --until 0.1 ") + apart).text, "starts inside")) << apart;
}

// Who gives marks hears that the cases are drawn by a seed everybody has; who tries or replays does not.
TEST_F(Program, SaysWhenMarksComeOfThePublicSeed) {
  fs::create_directories(dir / "class");
  fs::copy(RIGOR_SOURCE_DIR "/tests/submissions/kit", dir / "class" / "ada", fs::copy_options::recursive);
  const std::string hears = "seed is 20260414, the public default", in_class = "class " + (dir / "class").string() + " --cases 1 --out " + (dir / "out").string();
  const Ran ran = rigor_says(in_class);
  expect_eighty_columns(ran.text);
  EXPECT_TRUE(contains(ran.text, "rigor class: the default rubric: " + hears) && contains(ran.text, "set one of your own: seed = NUMBER")) << ran.text;
  EXPECT_FALSE(contains(rigor_says(in_class + " --seed 77").text, hears));
  const std::string own = " --rubric " + file("own.toml", "seed = 77"), points = " --rubric " + file("points.toml", "title = \"Rigid bodies\"");
  EXPECT_FALSE(contains(rigor_says(in_class + own).text, hears));
  EXPECT_TRUE(contains(rigor_says(in_class + points).text, hears));
  const std::string grade = "grade " + (dir / "class/ada").string() + " --check force.sum --cases 1";
  EXPECT_TRUE(contains(rigor_says(grade + points).text, hears));
  for (const std::string& other : {std::string(), own, points + " --practice", points + " --seed 20260414"}) EXPECT_FALSE(contains(rigor_says(grade + other).text, hears)) << other;
}

TEST_F(Program, DemoSaysBeforeItWorksThatItCannotWrite) {
  const Ran ran = rigor_says("demo --out /proc/demo");
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.text, "rigor demo: --out is /proc/demo, which cannot be made: No such file or directory\n");
}

// The bundled class has its page, and what is printed fits a screen.
TEST_F(Program, DemoFitsAScreenAndLinksTheClassPage) {
  const Ran ran = rigor_says("demo --out " + (dir / "demo").string());
  EXPECT_EQ(ran.status, 0) << ran.text;
  EXPECT_LE(std::count(ran.text.begin(), ran.text.end(), '\n'), 40) << ran.text;
  expect_eighty_columns(ran.text);
  EXPECT_TRUE(contains(ran.text, "seed 3") && contains(ran.text, "correction") && contains(ran.text, "inside walls")) << ran.text;
  EXPECT_TRUE(contains(*read_file(dir / "demo/index.html"), "href=\"class/class.html\""));
  const std::string page = *read_file(dir / "demo/class/class.html");
  for (const char* student : {"explicit-loops", "two-mistakes", "kit"}) {
    EXPECT_TRUE(contains(page, std::string("href=\"") + student + "/report.html\""));
    EXPECT_TRUE(fs::exists(dir / "demo/class" / student / "report.html"));
  }
}

TEST_F(Program, FitsEightyColumnsWhenItRunsAScene) {
  for (const char* scene : {"assignment", "drop", "tumble", "slide", "spin-box", "drop --method located", "assignment --until 2 --method located"}) {
    const Ran ran = rigor_says(std::string("run ") + scene);
    EXPECT_TRUE(contains(ran.text, "unexplained, worst")) << ran.text;
    expect_eighty_columns(ran.text);
  }
}

TEST_F(Program, SaysWhyALiveSceneCannotBe) {
  EXPECT_EQ(rigor_says("view nothing").status, 2);
  const Ran located = rigor_says("view drop --method located");
  EXPECT_EQ(located.status, 2);
  EXPECT_TRUE(contains(located.text, "--method sheet")) << located.text;
  EXPECT_EQ(rigor_says("view drop --port 65536").status, 2);
}

TEST_F(Program, AnswersWrongWordsWithStatusTwoAndASuggestion) {
  const std::pair<const char*, const char*> wrong[] = {
      {"exlain", "did you mean 'explain'?"},
      {"rnu", "did you mean 'run'?"},
      {"study drfit", "did you mean 'drift'?"},
      {"explain impulse.norml", "did you mean 'impulse.normal'?"},
      {"verify --id inertia.cubiod", "did you mean 'inertia.cuboid'?"},
      {"verify --cases 0", "--cases is 0, must be in [1, 100000000]"},
      {"verify --time nan", "--time is nan, must be in [0, 1e7] s"},
      {"verify --cases 7x", "--cases is 7x, must be in"},
      {"run assignmnt", "did you mean 'assignment'?"},
      {"run", "SCENE is required"},
      {"run drop --method shet", "did you mean 'sheet'?"},
      {"run drop --dt 0", "--dt is 0, must be in [1e-30, 1e30] s"},
      {"run drop --dt nan", "--dt is nan, must be in"},
      {"run drop --until", "--until needs a value"},
      {"run \"\"", "SCENE is empty, must be a file or a built-in scene"},
      {"run drop --out \"\"", "--out is empty, must be a directory"},
      {"run drop --method \"\"", "--method is '', which is none of the methods\n  known: sheet, "},
      {"run drop --explain --quiet", "--explain excludes --quiet"},
      {"run drop --until 1e6 --out " "/nowhere/rows", "--until is 1e+06 and every 0, gives 2.4e+08 rows of 1 cuboid, at most 2e7 are kept"},
      {"run drop --method located --every 1e-9", "--until is 3 and every 1e-09, gives 3e+09 rows of 1 cuboid, at most 2e7 are kept"},
      {"run drop --dt abc", "--dt is abc, must be in [1e-30, 1e30] s"},
      {"run drop --seed x", "--seed is x, must be in [1, 9007199254740992]"},
      {"run drop --beside nope", "known: sheet, "},
      {"view drop --port 99999", "--port is 99999, must be in [0, 65535]"},
      {"study drift --sums both", "--sums is both, must be one of plain, carried"},
      {"run drop --until -1", "--until is -1, must be in [0, 1e30] s"},
      {"study convergnce", "did you mean 'convergence'?"},
      {"study convergence --problem case-D", "did you mean 'case-A'?"},
      {"study convergence --method rk5", "did you mean 'rk4'?"},
      {"study convergence --until nan", "--until is nan, must be in [1e-30, 10000] s"},
      {"study convergence --problem case-A --h 0.3", "does not divide T = 10 s of case-A into whole steps; 10/33 does"},
      {"study work-precision --tolerance 1e-16", "--tolerance is 1e-16, must be in [1e-14, 0.1]"},
      {"study convergence --out ''", "--out is empty"},
      {"study convergence --submission ''", "--submission is empty"},
      {"check-table ''", "FILE is empty"},
      {"check-table --write ''", "--write is empty"},
      {"study work-precision --problem short-A --method rk4 --jobs 2", "--jobs: the runs of work-precision are timed, one after another"},
      {"study convergence --peer jolt", "is none of the peers\n  known: bullet, "},
      {"study convergence --submission /nowhere", "--submission: /nowhere"},
      {"study convergence --resume", "needs --out"},
      {"study drift --problem f-01", "--problem is f-01, which has a load that is not gravity alone: drift would leave it out; without: case-A, "},
      {"study convergence --method rk4,rk4", "--method has rk4 twice, must have it once"},
      {"study convergence --steps 5", "--steps is for drift, not for convergence"},
      {"study convergence --h 0.1 --rungs 3", "--rungs is of a ladder, --h names the steps"},
      {"study convergence --peers --peer ode", "--peers and --peer: both choose the peers"},
      {"study convergence --problem forced --submission " RIGOR_SOURCE_DIR "/tests/submissions/right/polar", "a submission is not asked for it"},
      {"check-table --write /proc/x", "--write: /proc/x cannot be written"},
      {"check-table mine.csv --write x", "--write: makes all tables anew"},
      {"check-table --within 1e-9", "--within: needs FILE"},
      {"check-table mine.csv --within 0", "--within is 0, must be in [1e-16, 1]"},
      {"study drift --step -1", "--step is -1, must be in [1e-30, 1e30] s"},
      {"grade", "a submission directory is missing"},
      {"grade /nowhere", "/nowhere"},
      {"grade /nowhere --check moi.bodi", "did you mean 'moi.body'?"},
      {"grade /nowhere --check moi.body --case 200", "--case is 200, must be in [0, 199]"},
      {"grade /nowhere --rubric /nowhere.toml", "/nowhere.toml does not exist"},
      {"grade /nowhere --format junit,html", "--format: 2 formats need a directory"},
      {"grade /nowhere /nowhere --format junit", "--format: of several submissions needs a directory"},
      {"grade /nowhere --practice --seed 5", "--practice and --seed: both choose the cases"},
      {"grade /nowhere --json --quiet", "--json and --quiet: both say what is printed"},
      {"explain moi.body", "'moi.body' is a check, its formula is 'inertia.cuboid'"},
      {"grade /nowhere --format pdf", "is none of text, json, html, junit, gradescope, autolab"},
      {"class /nowhere", "is not a directory"},
      {"class /nowhere --column Grade", "--column: is 'Grade' without --fill"},
      {"class " RIGOR_SOURCE_DIR "/tests/submissions/wrong --out " RIGOR_SOURCE_DIR "/tests/submissions/wrong/graded", "must be outside"},
      {"class " RIGOR_SOURCE_DIR "/tests/submissions/wrong --out " RIGOR_SOURCE_DIR "/tests/submissions/wrong/", "must be outside"},
      {"class " RIGOR_SOURCE_DIR "/tests/submissions/wrong --out /nowhere/x --against /nowhere/y/../x/", "--against: is the same directory as --out"},
      {"class " RIGOR_SOURCE_DIR "/tests/submissions/wrong --out /nowhere/x --against " RIGOR_SOURCE_DIR "/tests/submissions/right", "is not the --out of an earlier 'rigor class'"},
      {"grade /a1/hw /b1/hw --out /nowhere/multi", "/a1/hw and /b1/hw would both write to /nowhere/multi/hw"},
      {"--nonsense", "is required"},
      {"", "is required"},
  };
  for (const auto& [arguments, says] : wrong) {
    const Ran ran = rigor_says(arguments);
    EXPECT_EQ(ran.status, 2) << arguments << "\n" << ran.text;
    EXPECT_TRUE(contains(ran.text, says)) << arguments << "\n" << ran.text;
  }
}

TEST_F(Program, PrintsNoMarkWhenGradingIsInterrupted) {
  // an empty cache: compiling alone takes longer than the second it is given
  const Ran ran = rigor_says("grade " RIGOR_SOURCE_DIR "/tests/submissions/kit --out " + (dir / "out").string(),
                             "RIGOR_CACHE=" + (dir / "cache").string() + " timeout --foreground --preserve-status -s INT 1 ");
  EXPECT_EQ(ran.status, 130) << ran.text;
  EXPECT_TRUE(contains(ran.text, "interrupted, not graded")) << ran.text;
  EXPECT_FALSE(contains(ran.text, "of 100")) << ran.text;
  EXPECT_FALSE(std::filesystem::exists(dir / "out" / "report.json"));
}

TEST_F(Program, RefusesAClassBeforeItWritesAnything) {
  file("in/ada/Cuboid.cpp", "int a;");
  file("one/assignment_1_export/submission_1/Cuboid.cpp", "int a;");
  file("one/assignment_2_export/submission_1/Cuboid.cpp", "int a;");
  file("notes/notes.txt", "no submission");
  fs::create_directories(dir / "none");
  const auto zipped = [&](const std::string& what) {
    const std::string command = "cd " + (dir / what).string() + " && python3 -c \"import shutil; shutil.make_archive('../" + what + "', 'zip', '.')\"";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return (dir / (what + ".zip")).string();
  };
  const std::string in = (dir / "in").string(), good = zipped("in"), out = (dir / "out").string();
  const std::string rubric = file("bad.toml", "seed = 5\nsed = 6\n"), torn = file("torn.csv", "ID,Grade\n\"77,3\n"), nobody = file("nobody.csv", "Who,Grade\nada,\n");
  const std::pair<std::string, const char*> wrong[] = {
      {in + " --rubric " + rubric, "did you mean 'seed'?"},
      {good + " --rubric " + rubric, "did you mean 'seed'?"},
      {in + " --rubric /nowhere.toml", "/nowhere.toml does not exist"},
      {in + " --jobs 0", "--jobs is 0, must be in [1, 256]"},
      {in + " --cases 0", "--cases is 0, must be in [1, 100000]"},
      {in + " --seed x", "--seed is x, must be in [1, 9007199254740992]"},
      {in + " --fill /nowhere.csv", "--fill: /nowhere.csv does not exist"},
      {in + " --fill " + torn, "a quote is not closed"},
      {in + " --fill " + nobody, "has no column that names students"},
      {good + " --fill " + file("canvas.csv", "ID,Rigid\n77,\n") + " --column Rigd", "did you mean 'Rigid'?"},
      {in + " --against /nowhere", "--against: /nowhere is not a directory"},
      {good + " --against " + in, "is not the --out of an earlier 'rigor class'"},
      {(dir / "none").string(), "holds no submission"},
      {zipped("notes"), "holds no submission"},
      {(dir / "one").string(), "give one of them"},
      {zipped("one"), "give one of them"},
      {file("damaged.zip", "PK\003\004, and no more"), "damaged.zip"},
      {file("text.txt", "no archive"), "is not a directory"},
  };
  for (const auto& [arguments, says] : wrong) {
    const Ran ran = rigor_says("class " + arguments + " --out " + out);
    EXPECT_EQ(ran.status, 2) << arguments << "\n" << ran.text;
    EXPECT_TRUE(contains(ran.text, "rigor class: ") && contains(ran.text, says)) << arguments << "\n" << ran.text;
    EXPECT_FALSE(fs::exists(out)) << arguments;
  }
  const Ran blocked = rigor_says("class " + in + " --out " + file("blocked", "a file where a directory is wanted"));
  EXPECT_EQ(blocked.status, 2) << blocked.text;
  EXPECT_TRUE(contains(blocked.text, "--out: ") && contains(blocked.text, "cannot be written")) << blocked.text << "said before anybody is graded";
}

// Canvas hands out each file by itself: the command in the report names one of them, and grades what was graded.
TEST_F(Program, ReplaysASubmissionOfLooseFiles) {
  const fs::path sample = RIGOR_SOURCE_DIR "/tests/submissions/wrong/torque-kept";
  int n = 0;
  for (const auto& item : fs::directory_iterator(sample))
    if (item.path().extension() == ".cpp" || item.path().extension() == ".h") file("in/lovelaceada_77_" + std::to_string(++n) + "_" + item.path().filename().string(), *read_file(item.path()));
  const std::string out = (dir / "out").string();
  EXPECT_EQ(rigor_says("class " + (dir / "in").string() + " --cases 250 --quiet --out " + out).status, 0);
  const auto report = nlohmann::json::parse(*read_file(dir / "out/lovelaceada_77/report.json"));
  int replayed = 0;
  for (const auto& check : report["checks"]) {
    if (check["verdict"] != "fail" || check["max_points"] == 0) continue;
    const std::string command = check["replay"];
    EXPECT_TRUE(contains(command, " --cases 250")) << command << ": a case beyond the rubric's number can be asked for";
    const auto again = nlohmann::json::parse(rigor_says(command.substr(6) + " --json").text);
    EXPECT_EQ(again["submission"]["hash"], report["submission"]["hash"]);
    EXPECT_EQ(again["checks"][0]["verdict"], "fail") << command;
    EXPECT_EQ(again["checks"][0]["diagnosis"][0]["id"], check["diagnosis"][0]["id"]) << command;
    ++replayed;
  }
  EXPECT_GT(replayed, 0);
}

TEST_F(Program, PrintsAListOfSeveralReports) {
  const std::string kit = RIGOR_SOURCE_DIR "/tests/submissions/kit ";
  const auto list = nlohmann::json::parse(rigor_says("grade " + kit + kit + "--json --check moi.body 2>/dev/null").text, nullptr, false);
  ASSERT_TRUE(list.is_array());
  ASSERT_EQ(list.size(), 2u);
  for (const auto& report : list) EXPECT_EQ(report["submission"]["name"], "kit");
  EXPECT_EQ(nlohmann::json::parse(rigor_says("grade " + kit + "/nowhere --json --check moi.body 2>/dev/null").text, nullptr, false).size(), 1u) << "who could not be read is said on stderr";
  EXPECT_EQ(rigor_says("grade /nowhere /nowhere --json 2>/dev/null").text, "[]\n");
}

// The directory of a report is named as the report is; where two would share one, that is said before anything is graded.
TEST_F(Program, GivesEachReportTheDirectoryOfItsName) {
  for (const char* name : {"a\nb/Cuboid.cpp", "a\tb/Cuboid.cpp", "c/Cuboid.cpp"}) file(name, "int a;");
  const auto path = [&](const char* name) { return "'" + (dir / name).string() + "' "; };
  const std::string out = (dir / "out").string(), asks = "--check moi.body --cases 1 --quiet --format json --out " + out;
  const Ran two = rigor_says("grade " + path("a\nb") + path("a\tb") + asks);
  EXPECT_EQ(two.status, 2) << two.text;
  EXPECT_TRUE(contains(two.text, "would both write to " + out + "/a?b")) << two.text;
  EXPECT_FALSE(fs::exists(out));
  EXPECT_EQ(rigor_says("grade " + path("a\nb") + path("c/../c/") + asks).status, 0);
  for (const char* name : {"a?b", "c"}) {
    const auto report = read_file(dir / "out" / name / "report.json");
    ASSERT_TRUE(report) << name;
    EXPECT_EQ(nlohmann::json::parse(*report)["submission"]["name"], name);
  }
}

TEST_F(Program, NamesAStudentOnceWhereAClassIsInterrupted) {
  const Ran ran = rigor_says("class " RIGOR_SOURCE_DIR "/tests/submissions/kit/.. --out " + (dir / "out").string(),
                             "RIGOR_CACHE=" + (dir / "cache").string() + " timeout --foreground --preserve-status -s INT 1 ");
  EXPECT_EQ(ran.status, 130) << ran.text;
  EXPECT_TRUE(contains(ran.text, "rigor class: kit: interrupted\n")) << ran.text;
  EXPECT_FALSE(contains(ran.text, "interrupted while")) << ran.text;
}

TEST_F(Program, RefusesBrokenScenesAndLeavesNothingBehind) {
  for (const std::string& text : {std::string("{\"cuboids\": ["), std::string("\0\1\2\xff", 4), std::string("{\"cuboids\": [], \"gravty\": [0,0,0]}"), std::string(300000, '[')}) {
    const Ran ran = rigor_says("run " + file("scene.json", text) + " --out " + (dir / "out").string());
    EXPECT_EQ(ran.status, 2) << ran.text;
    EXPECT_TRUE(contains(ran.text, "scene.json")) << ran.text;
    EXPECT_FALSE(fs::exists(dir / "out"));
  }
}

TEST_F(Program, GradesNothingGradableWithStatusTwo) {
  fs::create_directories(dir / "empty");
  EXPECT_EQ(rigor_says("grade " + (dir / "empty").string()).status, 2);
  file("other/notes.txt", "no code here");
  EXPECT_EQ(rigor_says("grade " + (dir / "other").string()).status, 2);
}

TEST_F(Program, WritesWholeFilesAndTheSameOnesTwice) {
  EXPECT_EQ(rigor_says("run tumble --until 1 --out " + (dir / "a").string()).status, 0);
  EXPECT_EQ(rigor_says("run tumble --until 1 --out " + (dir / "b").string() + " --quiet").text, "");
  EXPECT_EQ(*read_file(dir / "a" / "trajectory.csv"), *read_file(dir / "b" / "trajectory.csv"));
  const auto summary = nlohmann::json::parse(*read_file(dir / "a" / "summary.json"));
  for (const char* key : {"energy", "linear_momentum", "angular_momentum", "impacts", "skips", "handed_over", "wall_s"}) EXPECT_TRUE(summary.contains(key)) << key;
}

// The lines of --beside are those of the methods run alone.
TEST_F(Program, ComparesMethodsLineUnderLine) {
  const Ran ran = rigor_says("run spin-box --until 2 --beside rk4,located");
  EXPECT_EQ(ran.status, 0) << ran.text;
  expect_eighty_columns(ran.text);
  const auto json = nlohmann::json::parse(rigor_says("run spin-box --until 2 --beside rk4,located --json").text);
  ASSERT_EQ(json["beside"].size(), 2u);
  for (const std::string method : {"sheet", "rk4", "located"}) {
    const auto& its = method == "sheet" ? json : json["beside"][method == "rk4" ? 0 : 1];
    const auto alone = nlohmann::json::parse(rigor_says("run spin-box --until 2 --json --method " + method).text);
    std::istringstream lines(ran.text.substr(ran.text.find("by method:")));
    std::string line, name;
    double energy = 0, own = 0;
    while (name != method && std::getline(lines, line)) std::istringstream(line) >> name >> energy >> own;
    EXPECT_EQ(name, method) << ran.text;
    EXPECT_NEAR(energy, double(alone["energy"]["end"]), 1e-5 * energy) << line;
    EXPECT_NEAR(own, double(alone["energy"]["worst_stepper"]), 0.06 * own) << line;
    for (const char* key : {"method", "energy", "linear_momentum", "angular_momentum", "impacts", "t_end"}) EXPECT_EQ(its[key], alone[key]) << method << " " << key;
    EXPECT_FALSE(alone.contains("beside"));
  }
}

// Every key of summary.json stands in the table of docs/scenes.md, in a row of the key it is in.
TEST_F(Program, WritesASummaryWhoseKeysAreDocumented) {
  const std::string landing = file("landing.json", R"({"cuboids": [{"size": [1, 1, 1], "mass": 1, "position": [0, 2, 0]}, {"size": [1, 1, 1], "mass": 1, "position": [9, 0.4, 0]}],
    "planes": [{"point": [0, 0, 0], "normal": [0, 1, 0]}], "restitution": 0.5, "static_friction": 0.5, "method": "located", "until": 3})");
  const auto summary = nlohmann::json::parse(rigor_says("run " + landing + " --json").text);
  ASSERT_FALSE(summary.at("handed_over").empty() || summary.at("accumulations").empty());
  const std::string page = *read_file(RIGOR_SOURCE_DIR "/docs/scenes.md");
  std::vector<std::string> rows;
  std::istringstream lines(page.substr(page.find("`summary.json`: the run's")));
  for (std::string line; std::getline(lines, line) && !line.starts_with("`replay.html`");)
    if (line.starts_with("| `")) rows.push_back(line.substr(0, line.find(" |", 2)) + line.substr(line.rfind(" | ")));
  const auto documented = [&](const std::string& in, const std::string& key) {
    return std::any_of(rows.begin(), rows.end(), [&](const std::string& row) { return contains(row, "`" + key + "`") && (in.empty() || contains(row.substr(0, row.find(": ")), "`" + in + "`")); });
  };
  for (const auto& [key, value] : summary.items()) {
    EXPECT_TRUE(documented("", key)) << key;
    const auto& inner = value.is_array() && !value.empty() ? value[0] : value;
    if (!inner.is_object()) continue;
    for (const auto& [name, ignored] : inner.items()) EXPECT_TRUE(documented(key, name)) << key << "." << name;
  }
  EXPECT_FALSE(documented("", "nonsense")) << "the test must be able to fail";
}

TEST_F(Program, ShowsTheFirstOfALongListAndWhereTheRestIs) {
  std::string cuboids;
  for (int k = 0; k < 14; ++k) cuboids += (k == 0 ? "" : ", ") + std::string(R"({"size": [1, 1, 1], "mass": 1, "position": [)") + std::to_string(3 * k) + ", 0.4, 0]}";
  const std::string scene = file("many.json", R"({"cuboids": [)" + cuboids + R"(], "planes": [{"point": [0, 0, 0], "normal": [0, 1, 0]}], "method": "located", "until": 0.5})");
  const Ran ran = rigor_says("run " + scene);
  EXPECT_TRUE(contains(ran.text, "handed over        cuboid 9,")) << ran.text;
  EXPECT_FALSE(contains(ran.text, "handed over        cuboid 10,")) << ran.text;
  EXPECT_TRUE(contains(ran.text, "and 4 more: summary.json has all")) << ran.text;
  expect_eighty_columns(ran.text);
  EXPECT_EQ(nlohmann::json::parse(rigor_says("run " + scene + " --json").text).at("handed_over").size(), 14u);
}

// What is printed stands before what went wrong, also where both go to one pipe: no line inside another.
TEST_F(Program, EndsWithTheReasonAfterAnInterrupt) {
  const Ran ran = rigor_says("run assignment --until 1e6 --every 1000 --explain", "timeout --foreground --preserve-status -s INT 1 ");
  EXPECT_EQ(ran.status, 130) << ran.text;
  const std::string last = ran.text.substr(ran.text.rfind('\n', ran.text.size() - 2) + 1);
  EXPECT_TRUE(last.starts_with("rigor run: interrupted at t = ") && last.ends_with("; what is shown and written ends there\n")) << ran.text;
}

// A reference in 60 digits over 10000 s takes minutes: a terminal says what is waited for, and an interrupt ends it at once.
TEST_F(Program, StudiesEndWhileTheirReferenceIsMade) {
  const std::string asks = "study convergence --problem case-A --until 1e4 --out " + (dir / "out").string(), said = "rigor study: interrupted before anything was measured\n";
  for (const auto& [signal, status] : {std::pair{"INT", 130}, {"TERM", 143}}) {
    const Ran ran = rigor_says(asks, std::string("timeout --foreground --preserve-status -k 20 -s ") + signal + " 1 ");
    EXPECT_EQ(ran.status, status);
    EXPECT_EQ(ran.text, said);
  }
  const Ran shown = rigor_says(asks + "' /dev/null", "script -qec 'timeout --foreground --preserve-status -k 20 -s INT 4 ");
  EXPECT_TRUE(contains(shown.text, "making the references of the problems in 60 digits, 2 s")) << shown.text;
  EXPECT_FALSE(fs::exists(dir / "out"));
}

// A study none of whose runs gave a number is no success; one that gave some is.
TEST_F(Program, StudiesOfWhichEveryRunFailedEndWithStatusOne) {
  const std::string asks = "study drift --problem case-A --step 1e30 --steps 10 --sums plain --quiet --method ";
  const Ran ran = rigor_says(asks + "rk4");
  EXPECT_EQ(ran.status, 1);
  EXPECT_EQ(ran.text, "rigor study: every run failed; the first: left the numbers after 0 steps\n");
  const Ran some = rigor_says("study convergence --problem case-A --method explicit-euler,rk4 --h 10 --quiet");
  EXPECT_EQ(some.status, 0) << some.text;
}

// The directory of a study takes the same one again, also longer, shorter or edited; it takes no other, with --resume or without.
TEST_F(Program, StudiesDoNotGoOnInTheDirectoryOfAnother) {
  const fs::path place = dir / "out";
  const std::string out = place.string(), asks = " --problem short-A --out " + out + " ";
  EXPECT_EQ(rigor_says("study convergence --method rk4 --rungs 3 --quiet" + asks).status, 0);
  const std::string list = *read_file(place / "cells.txt");
  for (const char* other : {"convergence --method sheet --rungs 3", "convergence --method rk4 --rungs 3 --until 2", "work-precision --method rk4 --rungs 3"})
    for (const char* how : {"", "--resume"}) {
      const Ran ran = rigor_says(std::string("study ") + other + asks + how);
      EXPECT_EQ(ran.status, 2) << ran.text;
      EXPECT_TRUE(ran.text.starts_with("rigor study: --out: " + out + " has another study, none of the cells asked for: there study=convergence problem=short-A method=rk4 steps=50 ")) << ran.text;
      EXPECT_EQ(*read_file(place / "cells.txt"), list);
    }
  EXPECT_EQ(rigor_says("study convergence --method rk4 --rungs 4 --quiet" + asks + "--resume").text, "");
  EXPECT_FALSE(contains(rigor_says("study convergence --method rk4 --rungs 4" + asks + "--resume").text, "not asked for"));
  file("out/figure-2.svg", "of a longer study");  // figure-1 is the only one now
  const Ran shorter = rigor_says("study convergence --method rk4 --rungs 2" + asks + "--resume");
  EXPECT_TRUE(contains(shorter.text, "\n2 more cells in " + out + "/cells, not asked for and not in these pages, stay there.\n")) << shorter.text;
  EXPECT_FALSE(fs::exists(place / "figure-2.svg"));
  EXPECT_EQ(rigor_says("study convergence --method rk4 --rungs 3 --problem short-A --quiet --resume --out " + (dir / "new").string()).text, "");  // nothing there yet
}

// An interrupted study says so wherever it is read, and --resume makes it whole.
TEST_F(Program, StudiesSayThatTheyWereInterrupted) {
  const fs::path out = dir / "out";
  const std::string asks = "study drift --problem short-A --method sheet,rk4,split2,split3,rkmk4,buss-augmented --sums plain --steps 3000000 --jobs 1 --out " + out.string();
  // once the first of six cells is there, however quick the machine (set -m: else a shell lets nobody behind it hear SIGINT)
  const std::string at_first_cell = "until ls " + (out / "cells").string() + "/*.json >/dev/null 2>&1; do sleep 0.02; done";
  const Ran ran = rigor_says(asks, "timeout 120 bash -c 'set -m; \"$@\" & study=$!; " + at_first_cell + "; kill -INT $study; wait $study' interrupted ");
  ASSERT_EQ(ran.status, 130) << ran.text;
  const auto json = nlohmann::json::parse(*read_file(out / "study.json"));
  EXPECT_EQ(json["interrupted"], true);
  EXPECT_EQ(json["cells"], 6);
  EXPECT_EQ(json["finished"], json["rows"].size());
  const std::string said = std::to_string(json["rows"].size()) + " of 6 cells; interrupted";
  EXPECT_LT(json["rows"].size(), 6u);
  EXPECT_TRUE(contains(ran.text, said + "\n")) << ran.text;
  for (const char* name : {"study.html", "README.md"}) EXPECT_TRUE(contains(*read_file(out / name), said)) << name;
  EXPECT_EQ(rigor_says(asks + " --resume --quiet").status, 0);
  EXPECT_EQ(nlohmann::json::parse(*read_file(out / "study.json"))["interrupted"], false);
  EXPECT_FALSE(contains(*read_file(out / "study.html"), "interrupted"));
}

TEST_F(Program, NamesTheFileAMethodCannotRun) {
  const std::string scene = file("pushed.json", R"({"cuboids": [{"size": [1, 1, 1], "mass": 1, "position": [0, 0, 0]}], "forces": [{"body": 0, "force": [1, 0, 0]}], "until": 1})");
  for (const char* option : {"--method", "--beside"}) {
    const Ran ran = rigor_says("run " + scene + " " + option + " located --out " + (dir / "out").string());
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(ran.text, "rigor run: " + scene + ": forces are not known to method 'located' (gravity is); use a stepper\n");
    EXPECT_FALSE(fs::exists(dir / "out"));
  }
}

TEST_F(Program, SaysWhatItWroteAndWhere) {
  const auto last_line = [](const std::string& text) { return text.substr(text.rfind('\n', text.size() - 2) + 1); };
  const auto exist = [](const fs::path& place, const std::string& line) {
    std::istringstream words(line.substr(line.find("beside it ") + 10));
    for (std::string name; words >> name;) EXPECT_TRUE(fs::exists(place / name.substr(0, name.find(',')))) << name;
  };
  const std::string a = (dir / "a").string();
  const std::string run = last_line(rigor_says("run tumble --until 0.1 --out " + a).text);
  EXPECT_TRUE(run.starts_with("wrote " + a + "/") || run.starts_with("  beside it")) << run;
  EXPECT_TRUE(contains(run, "beside it trajectory.csv, summary.json") || contains(run, "trajectory.csv; beside it summary.json")) << run;
  exist(a, run);
  EXPECT_FALSE(contains(rigor_says("run tumble --until 0.1 --json --out " + a).text, "wrote"));
  const std::string b = (dir / "b").string(), study = rigor_says("study convergence --problem short-A --method sheet --rungs 3 --out " + b).text;
  EXPECT_TRUE(contains(study, "wrote " + b + "/study.html")) << study;
  exist(b, study.substr(study.rfind("wrote ")));
}

// What is not finite is null in JSON and "-" on the terminal.
TEST_F(Program, HasNoNumberWhereThereIsNone) {
  const std::string scene = file("fast.json", R"({"cuboids": [{"size": [1, 2, 3], "mass": 1, "position": [0, 0, 0], "velocity": [1e30, 0, 0], "spin": [1e30, 1e30, 1]}], "method": "explicit-euler", "dt": 1, "until": 100})");
  const Ran ran = rigor_says("run " + scene + " --out " + (dir / "out").string());
  EXPECT_EQ(ran.status, 1);
  EXPECT_FALSE(contains(ran.text, "nan")) << ran.text;
  const auto summary = nlohmann::json::parse(*read_file(dir / "out" / "summary.json"));
  EXPECT_EQ(summary["finite"], false);
  EXPECT_TRUE(summary["energy"]["end"].is_null()) << summary["energy"];
}

TEST_F(Program, SaysWhenItCannotWrite) {
  const std::string blocked = file("blocked", "a file where a directory is wanted");
  const Ran ran = rigor_says("run tumble --until 0.1 --out " + blocked);
  EXPECT_EQ(ran.status, 2);
  EXPECT_TRUE(contains(ran.text, "cannot be written")) << ran.text;
}

TEST_F(Program, StudiesWriteNothingWhereTheyCannotAndEverythingWhereTheyCan) {
  const std::string blocked = file("blocked", "a file where a directory is wanted");
  const Ran ran = rigor_says("study convergence --problem short-A --method sheet --out " + blocked);
  EXPECT_EQ(ran.status, 2);
  EXPECT_TRUE(contains(ran.text, "--out") && contains(ran.text, "cannot be written")) << ran.text;
  EXPECT_EQ(*read_file(blocked), "a file where a directory is wanted");
  EXPECT_EQ(rigor_says("study convergence --problem short-A --method sheet --h 0.3 --out " + (dir / "none").string()).status, 2);
  EXPECT_FALSE(fs::exists(dir / "none"));
  const std::string asks = "study convergence --problem short-A --method sheet,rk4 --rungs 4 --quiet --out ";
  EXPECT_EQ(rigor_says(asks + (dir / "study").string()).text, "");
  for (const char* name : {"study.csv", "study.json", "study.html", "README.md", "figure-1.svg", "cells.txt"}) EXPECT_TRUE(fs::exists(dir / "study" / name)) << name;
  EXPECT_EQ(std::distance(fs::directory_iterator(dir / "study" / "cells"), fs::directory_iterator()), 8);
  EXPECT_EQ(rigor_says(asks + (dir / "study").string() + " --resume").status, 0);
  EXPECT_TRUE(contains(*read_file(dir / "study" / "README.md"), "Made by `rigor study convergence --problem short-A --method sheet,rk4 --rungs 4`"));
}

// A directory with somebody's README.md stays as it is, and nothing is measured; what a study wrote, the next one may write over.
TEST_F(Program, StudiesWriteOverNothingThatNoStudyWrote) {
  const std::string asks = "study drift --method rk4 --steps 1000 --out ", own = "# My own notes";
  for (const char* name : {"README.md", "study.csv", "study.html", "study.json", "cells.txt", "figure-1.svg"}) {
    const std::string theirs = file(std::string("theirs-") + name + "/" + name, own), place = fs::path(theirs).parent_path().string();
    const Ran ran = rigor_says(asks + place);
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(ran.text, "rigor study: --out: " + theirs + " is there and no study wrote it; give another directory\n");
    EXPECT_EQ(*read_file(theirs), own);
    EXPECT_EQ(std::distance(fs::directory_iterator(place), fs::directory_iterator()), 1);
  }
  const std::string twice = "study convergence --problem short-A --method sheet --rungs 3 --quiet --out " + (dir / "ours").string();
  EXPECT_EQ(rigor_says(twice).status, 0);
  EXPECT_EQ(rigor_says(twice).text, "");
}

// --resume takes no cell of a scene file or a submission that has changed since.
TEST_F(Program, StudiesMeasureAnewWhatWasEdited) {
  const auto scene = [&](const char* spin) {
    return file("flight.json", std::string("{\"cuboids\": [{\"mass\": 2, \"size\": [1, 2, 3], \"position\": [0, 0, 0], \"spin\": [") + spin + "]}], \"until\": 1}");
  };
  const auto csv = [&](const std::string& asks, const char* name, const char* more) {
    const Ran ran = rigor_says(asks + " --quiet --out " + (dir / name).string() + more);
    EXPECT_EQ(ran.text, "");
    return *read_file(dir / name / "study.csv");
  };
  const std::string flight = "study convergence --problem " + scene("0.3, 2, 0.2") + " --method rk4 --rungs 3";
  const std::string before = csv(flight, "a", "");
  EXPECT_EQ(csv(flight, "a", " --resume"), before);
  scene("0.3, 2.5, 0.2");
  const std::string after = csv(flight, "a", " --resume");
  EXPECT_NE(after, before);
  EXPECT_EQ(after, csv(flight, "b", ""));
  const auto cells = [&](const char* name) { return std::distance(fs::directory_iterator(dir / name / "cells"), fs::directory_iterator()); };
  EXPECT_EQ(cells("a"), 6);

  fs::copy(fs::path(RIGOR_SOURCE_DIR) / "tests/submissions/right/polar", dir / "ada");
  const std::string ada = "study convergence --problem short-A --method rk4 --rungs 3 --submission " + (dir / "ada").string();
  csv(ada, "c", "");
  EXPECT_EQ(cells("c"), 6);
  const fs::path code = dir / "ada" / "Cuboid.cpp";
  EXPECT_TRUE(write_file(code, *read_file(code) + "// one more line\n"));
  csv(ada, "c", " --resume");
  EXPECT_EQ(cells("c"), 9);
}

// The verdict over a whole table, as the user of another engine asks for it.
TEST_F(Program, ChecksATableToAThreshold) {
  const auto table = [](const char* name) { return RIGOR_SOURCE_DIR "/reference/tables/" + std::string(name) + ".csv"; };  // its own answers
  const Ran right = rigor_says("check-table " + table("free-flight") + " --within 1e-14");
  EXPECT_EQ(right.status, 0) << right.text;
  EXPECT_TRUE(contains(right.text, "\nwithin 1e-14: worst ") && contains(right.text, ", 49 of 49 cases answered\n")) << right.text;
  std::string text = *read_file(table("impacts"));
  const std::string some = file("some.csv", text.substr(0, text.find("\nlong-1,") + 1));
  const Ran partly = rigor_says("check-table " + some + " --table impacts --within 1e-9");
  EXPECT_EQ(partly.status, 1);
  EXPECT_TRUE(contains(partly.text, "\nnot within 1e-09: worst ") && contains(partly.text, ", 12 of 24 cases answered\n")) << partly.text;
  EXPECT_EQ(rigor_says("check-table " + some + " --table impacts").status, 0);
  const Ran other = rigor_says("check-table " + table("loaded-flight"));
  EXPECT_EQ(other.status, 2);
  EXPECT_TRUE(contains(other.text, "there is no case 'axial-1'") && contains(other.text, "; it fits --table loaded-flight\n")) << other.text;
  const Ran like = rigor_says("check-table " + some);  // its cases have names that the other table has too
  EXPECT_TRUE(contains(like.text, "some.csv fits --table impacts better\n")) << like.text;
  for (const char* name : {"free-flight", "loaded-flight", "impacts"}) {
    const Ran whole = rigor_says("check-table " + table(name) + " --within 1e-9 --table " + name);
    EXPECT_EQ(whole.status, 0);
    expect_eighty_columns(whole.text);
  }
}

TEST_F(Program, SaysInOneLineWhichFlagItDoesNotKnow) {
  const Ran ran = rigor_says("run drop --mthod rk4");
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.text, "rigor run: there is no option '--mthod' (did you mean '--method'?); 'rigor run --help' shows what it takes\n");
}

TEST_F(Program, OutputThatDoesNotArriveIsNoSuccess) {
  const fs::path said = dir / "said";
  EXPECT_EQ(rigor_says("run drop --until 0.1 --json 2>" + said.string() + " >/dev/full").status, 2);
  EXPECT_TRUE(contains(*read_file(said), "standard output cannot be written"));
}

TEST_F(Program, LooksAtEveryFlagBeforeItWritesAnything) {
  const Ran ran = rigor_says("run drop --beside rk5 --out " + (dir / "out").string());
  EXPECT_EQ(ran.status, 2);
  EXPECT_TRUE(contains(ran.text, "--beside is 'rk5', which is none of the methods")) << ran.text;
  EXPECT_FALSE(fs::exists(dir / "out"));
  EXPECT_EQ(rigor_says("run drop --seed -1").status, 2);
}

TEST_F(Program, ColoursATerminalUnlessAskedNotTo) {
  const std::string grade = "grade " RIGOR_SOURCE_DIR "/tests/submissions/kit --check force.torque --cases 2' /dev/null";
  EXPECT_TRUE(contains(rigor_says(grade, "NO_COLOR= script -qec '").text, "\x1b["));
  EXPECT_FALSE(contains(rigor_says(grade, "NO_COLOR=1 script -qec '").text, "\x1b["));
}

TEST_F(Program, PrintsJsonThatParses) {
  for (const char* arguments : {"explain --json", "explain impulse.normal --json", "verify --id impulse.normal --cases 50 --json", "run drop --until 0.1 --json",
                                "study convergence --problem short-A --method sheet --rungs 3 --json", "audit --seeds 1 --cases 2 --json"})
    EXPECT_TRUE(nlohmann::json::accept(rigor_says(arguments).text)) << arguments;
}

TEST_F(Program, ExplainsAFormulaWithEverythingThatIsKnownOfIt) {
  const Ran ran = rigor_says("explain impulse.normal");
  EXPECT_EQ(ran.status, 0);
  for (const char* part : {"j = −(1 + e) v_n / k_nn", "DERIVATION", "ERRATUM", "THEOREM", "BRIDGE", "ROUNDING BOUND", "within 3", "tests/exact/impulse_test.cpp", "CHECKS", "- plane.restitution: ", "worst rounding"})
    EXPECT_TRUE(contains(ran.text, part)) << part;
  EXPECT_FALSE(contains(ran.text, "\x1b")) << "colour escapes in a pipe";
}

TEST_F(Program, ExplainsInEightyColumns) {
  for (const std::string& id : cli::formula_ids(cli::texts())) {
    const Ran ran = rigor_says("explain " + id);
    EXPECT_EQ(ran.status, 0) << id;
    EXPECT_FALSE(contains(ran.text, "**")) << id << ": marks of bold";
    std::istringstream lines(ran.text);  // counted without bytes that continue a character, and dots set above another
    for (std::string line; std::getline(lines, line);) {
      const auto columns = std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80 && c != '\xCC' && c != '\xCD'; });
      const bool one_word = line.find(' ', line.find_first_not_of(' ')) == std::string::npos;  // a path: nothing to break at
      EXPECT_TRUE(one_word || columns <= 80) << id << ": " << line;
    }
  }
}

TEST(Explain, FillsParagraphsAndKeepsFormulas) {
  EXPECT_EQ(report::filled("one two\nthree four\n\nfive\n", 12, 2), "  one two\n  three four\n\n  five\n");
  EXPECT_EQ(report::filled("1. **one** two\n   three\n2. four\n", 13, 0), "1. one two\n   three\n2. four\n");
  EXPECT_EQ(report::filled("shapes    one two three\n          four\n", 18, 0), "shapes    one two\n          three\n          four\n");
  EXPECT_EQ(report::filled("so\n    j = −(1 + e)  v\nhere\n", 40, 1), " so\n     j = −(1 + e)  v\n here\n");
  EXPECT_EQ(report::filled("ω̇ ωω ω\n", 6, 0), "ω̇ ωω ω\n");
  EXPECT_EQ(report::folded("  let a := b in\nx", 10, 0), "  let a :=\n      b in\nx\n");
}

TEST(Explain, FindsADerivationForEveryFormula) {
  for (const std::string& id : cli::formula_ids(cli::texts())) {
    const auto e = cli::explain(cli::texts(), id);
    ASSERT_TRUE(e);
    EXPECT_NE(e->derivation, "") << id;
    EXPECT_FALSE(e->tests.empty()) << id;
  }
}

// What is wrong in the assignment's text is shown with a formula it is about; the points to settle are read in one piece.
TEST(Explain, ShowsEveryErratumOfTheText) {
  std::set<std::string> shown;
  for (const std::string& id : cli::formula_ids(cli::texts())) {
    const auto e = cli::explain(cli::texts(), id);
    shown.insert(e->errata.begin(), e->errata.end());
  }
  const auto errata = std::find_if(cli::texts().begin(), cli::texts().end(), [](const auto& t) { return t.path == "reference/errata.md"; });
  ASSERT_NE(errata, cli::texts().end());
  const std::string all(errata->content), text = all.substr(0, all.find("## Points to settle"));
  static const std::regex heading("\n##+ `[a-z-]+`");
  EXPECT_EQ(long(shown.size()), std::distance(std::sregex_iterator(text.begin(), text.end(), heading), std::sregex_iterator()));
}

// case S-11: no memory left is a sentence and a status, and no file half-written.
TEST_F(Program, SaysSoWhenMemoryRunsOut) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the address sanitizer needs more address space than the limit allows";
#endif
  const auto [status, text] = rigor_says("run assignment --until 3000 --out " + (dir / "big").string(), "ulimit -v 150000; ");
  EXPECT_EQ(status, 3) << text;
  EXPECT_TRUE(contains(text, "rigor: out of memory")) << text;
  EXPECT_FALSE(fs::exists(dir / "big" / "trajectory.csv"));
}

}  // namespace
}  // namespace rigor
