#pragma once
#include <map>
#include <rigor/studies/problem.hpp>
#include <rigor/studies/timing.hpp>

namespace rigor::studies {

/// Another engine, in a program of its own beside ours (rigor-peer-NAME), which can be built where its package is.
struct Peer {
  std::string name;      ///< "mujoco"
  std::string package;   ///< Debian's: "libmujoco-dev"
  bool installed;        ///< its package was there when the build was configured
};
const std::vector<Peer>& peers();

/// One way to run a peer.
struct PeerVariant {
  std::string name;      ///< "mujoco/rk4"
  std::string settings;  ///< version, and everything that was set, in words
  bool adaptive;         ///< asked for a tolerance instead of steps
  double ns;             ///< about what a step costs, for the length of its ladder
};

/// What an installed peer can do. Faults: unknown_key (no such peer, with a suggestion), unsupported (its program is
/// not there; says whether to build it or to install its package first), unreadable (it does not run).
Outcome<std::vector<PeerVariant>> peer_variants(const std::string& name);

struct PeerRun {
  State<double> end;
  Timing timing;
  double evaluations;   ///< of its equations, or its steps
  std::string settings;
};
/// A flight of a problem that `falls`, by "mujoco/rk4", with so many steps or at a tolerance. Faults: as above, and what the
/// peer says went wrong.
Outcome<PeerRun> run_peer(const std::string& variant, const Problem& problem, long steps, double tolerance);

}  // namespace rigor::studies
