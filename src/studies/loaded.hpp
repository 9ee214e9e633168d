#pragma once
#include <rigor/studies/problem.hpp>

/// The problems of the catalogue with a load that is not gravity alone. A maker gives the problem up to `until` s.
namespace rigor::studies {

Problem constant_push(const std::string& name, double until);       ///< F-01
Problem axial_torque(const std::string& name, double until);        ///< F-02
Problem springs(const std::string& name, double until);             ///< F-03
Problem drag(const std::string& name, double until);                ///< F-04: the load looks at velocities
Problem lagrange_top(const std::string& name, double until);        ///< F-05, in steady precession
Problem kovalevskaya_top(const std::string& name, double until);    ///< F-06
Problem goryachev_top(const std::string& name, double until);       ///< F-07
Problem chosen_motion(const std::string& name, double until);       ///< F-08
Problem changing_load(const std::string& name, double until);       ///< force and torque that change in time

}  // namespace rigor::studies
