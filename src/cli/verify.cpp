#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/cli/in_range.hpp>
#include <rigor/cli/progress.hpp>
#include <rigor/cli/explain.hpp>
#include <rigor/cli/terminal_width.hpp>
#include <rigor/cli/verify.hpp>
#include <rigor/report/wrap.hpp>
#include <rigor/verify/verify.hpp>

namespace rigor::cli {
namespace {

struct VerifyOptions {
  std::string id;
  long cases = 2000;
  double seconds = 0;
  std::uint64_t seed = 1;
  bool json = false;
};

// A soak adds the counts of one round to those before and keeps the worst.
void merge(verify::Result& sum, const verify::Result& more) {
  for (std::size_t i = 0; i < sum.identities.size(); ++i) {
    sum.identities[i].cases += more.identities[i].cases;
    sum.identities[i].held += more.identities[i].held;
  }
  for (std::size_t i = 0; i < sum.roundings.size(); ++i) {
    sum.roundings[i].cases += more.roundings[i].cases;
    sum.roundings[i].worst = std::max(sum.roundings[i].worst, more.roundings[i].worst);
  }
  const auto merge_agreements = [](std::vector<verify::Agreement>& rows, const std::vector<verify::Agreement>& others) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].cases += others[i].cases;
      rows[i].worst = std::max(rows[i].worst, others[i].worst);
    }
  };
  merge_agreements(sum.agreements, more.agreements);
  merge_agreements(sum.engines, more.engines);
}

nlohmann::json as_json(const verify::Result& result, const VerifyOptions& options) {
  nlohmann::json out{{"seed", options.seed}, {"ok", result.ok()}};
  for (const auto& r : result.identities)
    out["identities"].push_back({{"id", r.id}, {"says", r.says}, {"cases", r.cases}, {"held", r.held}});
  for (const auto& r : result.roundings)
    out["roundings"].push_back({{"id", r.id}, {"bound", r.bound}, {"cases", r.cases}, {"worst_ratio", r.worst}});
  const auto agreement = [](const verify::Agreement& r) {
    return nlohmann::json{{"id", r.id}, {"oracle", r.oracle}, {"cases", r.cases}, {"worst", r.worst}, {"bound", r.bound}};
  };
  for (const auto& r : result.agreements) out["agreements"].push_back(agreement(r));
  for (const auto& r : result.engines) out["engines"].push_back(agreement(r));
  for (const auto& r : result.absent) out["absent"].push_back({{"id", r.id}, {"part", r.part}, {"why", r.why}});
  return out;
}

template <class Row>
const char* mark(const Row& row, const char* broken) {
  return row.ok() ? "" : row.cases == 0 ? "   not run" : broken;
}

void print(const std::vector<verify::Agreement>& rows) {
  for (const auto& r : rows)
    std::printf("  %-30s %8.1e <= %-8.1e %6ld cases%s\n%s", r.id.c_str(), r.worst, r.bound, r.cases,
                mark(r, "   ABOVE"), report::filled(r.oracle, terminal_width(), 6).c_str());
}

void print(const verify::Result& result) {
  if (!result.identities.empty()) std::printf("EXACT IDENTITIES over the rationals, checked with ==\n");
  for (const auto& r : result.identities)
    std::printf("  %-30s %ld of %ld%s\n%s", r.id.c_str(), r.held, r.cases, mark(r, "   DOES NOT HOLD"),
                report::filled(r.says, terminal_width(), 6).c_str());
  if (!result.roundings.empty()) std::printf("\nROUNDING: double against exact, worst |error| / bound (must stay <= 1)\n");
  for (const auto& r : result.roundings)
    std::printf("  %-30s %6.3f of %-18s %9ld cases%s\n", r.id.c_str(), r.worst, r.bound.c_str(), r.cases,
                mark(r, "   ABOVE"));
  if (!result.absent.empty()) std::printf("\nWITHOUT A ROW\n");
  for (const auto& r : result.absent) std::printf("%s", report::filled(r.id + ", " + r.part + ": " + r.why, terminal_width(), 2).c_str());
  if (!result.agreements.empty()) std::printf("\nORACLES: agreement with a method that does not share the formula\n");
  print(result.agreements);
  if (!result.engines.empty()) std::printf("%sENGINES: each fast path against a plain one or another author\n", result.agreements.empty() ? "" : "\n");
  print(result.engines);
}

int verify_command(const VerifyOptions& options) {
  std::vector<std::string> ids = formula_ids(texts());
  for (const std::string& id : verify::engine_ids()) ids.push_back(id);
  if (!options.id.empty() && std::find(ids.begin(), ids.end(), options.id) == ids.end()) {
    std::fprintf(stderr, "rigor verify: there is no formula or engine '%s'%s; 'rigor verify' without --id shows all\n",
                 options.id.c_str(), did_you_mean(options.id, ids).c_str());
    return 2;
  }
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  Progress progress(options.seconds > 0, " s");
  verify::Result result = verify::run(options.id, options.cases, options.seed);
  for (std::uint64_t round = 1; elapsed() < options.seconds && interrupted() == 0; ++round) {
    progress(long(elapsed()), long(std::ceil(options.seconds)));
    merge(result, verify::run(options.id, options.cases, options.seed + round));
  }
  progress.clear();
  if (options.json) std::printf("%s\n", as_json(result, options).dump(2).c_str());
  else print(result);
  if (interrupted() != 0) {
    std::fprintf(stderr, "rigor verify: interrupted; the figures are of the cases run so far\n");
    return 128 + interrupted();
  }
  if (!options.json)
    std::printf("\n%s: %zu formulas, %zu engines, %.1f s, seed %llu\n", result.ok() ? "all held" : "NOT all held",
                result.agreements.size(), result.engines.size(), elapsed(), static_cast<unsigned long long>(options.seed));
  return result.ok() ? 0 : 1;
}

}  // namespace

void add_verify(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand("verify", "property run over the built-in formulas and engines; a soak with --time");
  command->add_option("--id", options->id, "only this formula, or engine.exact-flight, engine.batch, engine.located");
  command->add_option("--cases", options->cases, "random inputs for each formula and round")
      ->check(in_range(1L, 100000000L))
      ->capture_default_str();
  command->add_option("--time", options->seconds, "go on with new seeds for so many seconds")
      ->check(in_range(0.0, 1e7, "s"));
  command->add_option("--seed", options->seed, "same seed, same numbers")->check(in_range(std::uint64_t(0), std::uint64_t(1) << 53))->capture_default_str();
  command->add_flag("--json", options->json, "as JSON");
  command->footer("Example:  rigor verify --id impulse.normal --cases 100000");
  command->callback([options, &exit_status] { exit_status = verify_command(*options); });
}

}  // namespace rigor::cli
