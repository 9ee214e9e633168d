#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <rigor/base/interrupt.hpp>
#include <rigor/cli/in_range.hpp>
#include <rigor/cli/refused.hpp>
#include <rigor/cli/view.hpp>
#include <rigor/live/server.hpp>
#include <rigor/scene/method_names.hpp>
#include <rigor/view/page.hpp>

namespace rigor::cli {
namespace {

struct ViewOptions {
  std::string scene, method;
  std::uint64_t seed = 0;
  unsigned short port = 0;
};

int refuse_view(const Fault& fault) { return refused("view", fault.text()); }

int view_command(const ViewOptions& options) {
  auto opened = open_scene(options.scene, options.seed);
  if (!opened) return refuse_view(opened.fault());
  Scene scene = *opened;
  if (!options.method.empty()) scene.method = options.method;
  if (const auto ok = check_scene(scene); !ok) return refuse_view({ok.fault().kind, "--" + ok.fault().where, ok.fault().what});
  const auto names = builtin_scenes();
  const bool built_in = std::find(names.begin(), names.end(), options.scene) != names.end();
  const auto reseed = [&](std::uint64_t seed) {  // a file's scene has no other random numbers than the vacuum's offsets
    Scene next = built_in ? builtin_scene(options.scene, seed) : scene;
    next.seed = seed;
    return next;
  };
  auto live = live::LiveScene::make(scene, reseed);
  if (!live) return refuse_view(live.fault());
  const auto page_for = [&](unsigned short port) {
    const std::string number = std::to_string(port);
    return view::render({"live", std::filesystem::path(scene.name).filename().string(), "live: what is pressed and pulled here happens in the simulation",
                         "ws://127.0.0.1:" + number + " ws://localhost:" + number, {{"schema", "rigor.live/1"}}});
  };
  auto server = live::Server::open(std::move(live).value(), options.port, page_for);
  if (!server) return refuse_view(server.fault());
  std::printf("%s\n  space starts and stops, r vacuum, g gravity, n a new seed; Ctrl-C ends\n", (*server)->address().c_str());
  std::fflush(stdout);
  (*server)->run([] { return interrupted() != 0; });
  return 0;
}

}  // namespace

void add_view(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand("view", "a scene live in a browser: keys, sliders, a hand that pulls");
  command->add_option("SCENE", options->scene, "a JSON file, or a built-in: assignment, drop, tumble, slide, spin-box")->required();
  command->add_option("--port", options->port, "of 127.0.0.1; any free one by default")->check(in_range(0, 65535));
  command->add_option("--seed", options->seed, "of the scene's random numbers")->check(in_range(std::uint64_t(1), std::uint64_t(1) << 53));
  command->add_option("--method", options->method, "integrator in place of the scene's");
  command->footer("Methods: " + fmt::format("{}", fmt::join(method_names(), ", ")) + "\n\nExample:  rigor view assignment");
  command->callback([options, &exit_status] { exit_status = view_command(*options); });
}

}  // namespace rigor::cli
