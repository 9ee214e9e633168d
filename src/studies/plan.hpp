#pragma once
#include <optional>
#include <rigor/studies/cell.hpp>

namespace rigor::studies {

/// What somebody wants studied. Everything left empty has the study's own standard.
struct StudyRequest {
  std::string kind;
  std::vector<std::string> problems{}, methods{};
  std::vector<std::string> peers{};       ///< by name; "mujoco"
  std::string submission{};               ///< "submission NAME HASH": a built one's cells
  std::optional<double> until{};          ///< s
  std::optional<long> coarsest{};         ///< steps of the first run; each next has twice as many
  std::optional<int> rungs{};
  std::vector<double> h{};                ///< s: these steps instead of a ladder
  std::vector<double> tolerances{};       ///< of adaptive ways and peers
  std::optional<long> steps{};            ///< of drift; 1000000
  std::optional<double> step{};           ///< of drift, s; 0.01
  std::vector<std::string> sums{};        ///< of drift: "plain", "carried"; both
};

const std::vector<std::string>& study_kinds();

/// What may be asked to fly: our methods, those by the closed form, and the other ways.
std::vector<std::string> flying_methods();

/// The cells of a study. Opens the problems. Faults name the option: unknown_key (kind, problem, method, peer; with a
/// suggestion), out_of_range (T, steps that do not divide it, a tolerance below rounding, a name or number that is there twice), unsupported (a peer that
/// is not installed, a problem or an option that is not of this study or not of what is asked to fly).
Outcome<std::vector<Cell>> plan(const StudyRequest& request);

}  // namespace rigor::studies
