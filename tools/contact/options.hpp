/// The options of asperity-contact, checked as far as the command line alone allows.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "contact/bodies.hpp"
#include "contact/solver.hpp"
#include "tools/cli/ensemble_input.hpp"
#include "tools/contact/plasticity.hpp"

namespace asperity::cli {

struct ContactOptions {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  static constexpr double flat = std::numeric_limits<double>::infinity();

  EnsembleInput surfaces;  ///< first bodies
  std::string variable = "heights", counter, boundary;
  bool smooth = false;
  Shape shape;
  std::array<double, 2> size{none, none};

  Bodies bodies{.young = {none, none}, .poisson = {none, none}};
  std::string radius_option = "radius";  ///< the one that gave the radii

  const Ranks* ranks = &alone();  ///< that press together
  ContactParameters contact;      ///< of a sweep with its first load
  std::vector<double> loads;      ///< of a sweep; empty: one contact is solved and written
  bool by_mean_pressure = false;  ///< all loads are mean pressures [Pa], until force_on()
  std::string each;               ///< pattern of the datasets of a sweep, or of several surfaces
  std::vector<std::string> add;   ///< further results
  double accuracy = 0;            ///< largest relative error of the grid; 0: whatever it is
  PlasticOptions plastic;         ///< flow below the surface, where it is asked for

  bool sweeps() const { return !loads.empty(); }
  bool several() const { return surfaces_ > 1; }
  bool tabulates() const { return sweeps() || several(); }  ///< a table is printed, in place of a dataset
  bool adds(std::string_view result) const { return std::ranges::find(add, result) != add.end(); }
  bool unloads() const { return adds("heights_residual"); }
  std::string load_unit() const { return by_mean_pressure ? "Pa" : "N"; }
  /// The load [N] that one of the loads is on this grid.
  double force_on(const Grid& grid, double load) const;
  void declare(Tool& tool);
  /// After parsing: throws ParameterError when options do not go together or are out of bounds. Reads
  /// the list of the surfaces, if there is one.
  void check(Tool& tool);

 private:
  void declare_surface(Tool& tool);
  void declare_bodies(Tool& tool);
  void declare_load(Tool& tool);
  void declare_sweep(Tool& tool);
  void check_load(const Tool& tool);
  void check_mean_pressure(const char* name) const;
  void check_added() const;
  void check_flow(const Tool& tool);
  void check_accuracy(const Tool& tool);
  void check_streams(Tool& tool);
  void check_table(Tool& tool) const;

  std::array<double, 2> radius_{flat, flat}, radius_x_{flat, flat}, radius_y_{flat, flat};
  double load_ = none, mean_pressure_ = none, approach_ = none;
  std::string loads_, accuracy_;
  std::size_t surfaces_ = 1;
  void check_ranks(const Tool& tool);
};

}  // namespace asperity::cli
