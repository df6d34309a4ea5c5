#include "plastic/layer_waves.hpp"

#include <Eigen/LU>

namespace asperity {

using namespace deviator;

LayerWaves::LayerWaves(std::vector<double> thickness, double poisson)
    : thickness_(std::move(thickness)), l_(poisson / (1 - poisson)), e_(2 / (1 - poisson)) {
  const double nu = poisson, m = (1 - 2 * nu) / (2 - 2 * nu);
  states_ << 1, 0, 1, 0,                            //
      1, 3 - 4 * nu, -1, 3 - 4 * nu,                //
      -2, -2 * (1 - 2 * nu), 2, -2 * (1 - 2 * nu),  //
      -2, -4 * (1 - nu), -2, 4 * (1 - nu);
  Eigen::Matrix<double, 4, 3> b;
  b << 0, 0, 1, 0, m, 0, -1, l_, 0, 0, 0, 0;
  Eigen::Matrix3d load;  // (T11, T33, i T13) from (d0, d1, i d3)
  load << root_half, -root_sixth, 0, 0, root_two_thirds, 0, 0, 0, root_half;
  sources_ = states_.inverse() * b * load;
  reflection_ = -states_.block<2, 2>(2, 0).inverse() * states_.block<2, 2>(2, 2);
}

LayerWaves::Work::Work(Index layers)
    : x(size(layers * components)),
      mean(size(layers)),
      e_(size(layers)),
      phi_(size(layers)),
      eta_(size(layers)),
      up_(size(layers * 3)),
      uniform_strain_(size(layers * components)) {}

void LayerWaves::prepare(const Lanes& qx, const Lanes& qy, Work& work) const {
  Lanes q = (qx.square() + qy.square()).sqrt();
  work.uniform_ = -1;
  for (Index l = 0; l < lanes; ++l)
    if (q[l] == 0) {
      work.uniform_ = l;
      q[l] = 1 / thickness_.front();  // any
    }
  work.cos_ = qx / q;
  work.sin_ = qy / q;
  work.cos2_ = work.cos_.square() - work.sin_.square();
  work.sin2_ = 2 * work.cos_ * work.sin_;
  for (std::size_t k = 0; k < thickness_.size(); ++k) {
    work.eta_[k] = q * thickness_[k];
    work.e_[k] = (-work.eta_[k]).exp();
    work.phi_[k] = (1 - work.e_[k]) / work.eta_[k];
  }
}

void LayerWaves::respond(Work& work, bool with_mean) const {
  if (work.uniform_ >= 0)
    for (std::size_t n = 0; n < work.x.size(); ++n) work.uniform_strain_[n] = work.x[n][work.uniform_];
  std::array<Lanes, 3> at_surface;
  sweep_up(work, at_surface);
  sweep_down(work, at_surface, with_mean);
  if (work.uniform_ >= 0) set_uniform(work);
}

// The strain of layer k, turned by the angle of q.
void LayerWaves::to_frame(Work& work, Index k) const {
  Lanes* x = work.x.data() + k * components;
  const Lanes d0 = x[0], d3 = x[3];
  x[0] = work.cos2_ * d0 + work.sin2_ * x[2];
  x[2] = work.cos2_ * x[2] - work.sin2_ * d0;
  x[3] = work.cos_ * d3 + work.sin_ * x[4];
  x[4] = work.cos_ * x[4] - work.sin_ * d3;
}

// The means of what fades upwards, and what arrives at the surface.
void LayerWaves::sweep_up(Work& work, std::array<Lanes, 3>& at_surface) const {
  auto& [a1, a2, b] = at_surface;
  a1 = a2 = b = Lanes::Zero();
  for (Index k = layers() - 1; k >= 0; --k) {
    to_frame(work, k);
    const Lanes *x = work.x.data() + k * components, &e = work.e_[size(k)], &phi = work.phi_[size(k)],
                &eta = work.eta_[size(k)];
    Lanes* mean = work.up_.data() + 3 * k;
    const Lanes g1 = sources_(2, 0) * x[0] + sources_(2, 1) * x[1] + sources_(2, 2) * x[3],
                g2 = sources_(3, 0) * x[0] + sources_(3, 1) * x[1] + sources_(3, 2) * x[3],
                gb = 0.5 * root_half * (x[4] - x[2]), slope = phi - e;
    mean[0] = phi * a1 - slope * a2 - (1 - phi) * g1 + (1 - phi - slope) * g2;
    mean[1] = phi * a2 - (1 - phi) * g2;
    mean[2] = phi * b - (1 - phi) * gb;
    a1 = e * (a1 - eta * a2) - (1 - e) * g1 + eta * slope * g2;
    a2 = e * a2 - (1 - e) * g2;
    b = e * b - (1 - e) * gb;
  }
}

void LayerWaves::sweep_down(Work& work, const std::array<Lanes, 3>& at_surface, bool with_mean) const {
  const Eigen::Matrix2d& r = reflection_;
  Lanes a1 = r(0, 0) * at_surface[0] + r(0, 1) * at_surface[1],
        a2 = r(1, 0) * at_surface[0] + r(1, 1) * at_surface[1], b = at_surface[2];
  for (Index k = 0; k < layers(); ++k) {
    Lanes* x = work.x.data() + k * components;
    const Lanes &e = work.e_[size(k)], &phi = work.phi_[size(k)], &eta = work.eta_[size(k)];
    const Lanes* up = work.up_.data() + 3 * k;
    const Lanes g1 = sources_(0, 0) * x[0] + sources_(0, 1) * x[1] + sources_(0, 2) * x[3],
                g2 = sources_(1, 0) * x[0] + sources_(1, 1) * x[1] + sources_(1, 2) * x[3],
                gb = 0.5 * root_half * (x[4] + x[2]), slope = phi - e;
    const Lanes m1 = phi * a1 + slope * a2 + (1 - phi) * g1 + (1 - phi - slope) * g2,
                m2 = phi * a2 + (1 - phi) * g2, mb = phi * b + (1 - phi) * gb;
    a1 = e * (a1 + eta * a2) + (1 - e) * g1 + eta * slope * g2;
    a2 = e * a2 + (1 - e) * g2;
    b = e * b + (1 - e) * gb;

    auto state = [&](Index i) -> Lanes {
      return states_(i, 0) * m1 + states_(i, 1) * m2 + states_(i, 2) * up[0] + states_(i, 3) * up[1];
    };
    const Lanes u1 = m1 + up[0], s13 = state(2), s33 = state(3);
    const double own = (1 + 2 * l_) / 3;
    if (with_mean) work.mean[size(k)] = (e_ + 2 * l_) / 3 * u1 + own * (s33 + root_two_thirds * x[1]);
    const Lanes d0 = std::numbers::sqrt2 * u1 - x[0], d2 = std::numbers::sqrt2 * (up[2] + mb) - x[2],
                d3 = std::numbers::sqrt2 * s13, d4 = std::numbers::sqrt2 * (up[2] - mb);
    x[1] = root_sixth * (2 * (1 - l_) * s33 - (e_ + 2 * l_) * u1) - own * x[1];
    x[0] = work.cos2_ * d0 - work.sin2_ * d2;
    x[2] = work.cos2_ * d2 + work.sin2_ * d0;
    x[3] = work.cos_ * d3 - work.sin_ * d4;
    x[4] = work.cos_ * d4 + work.sin_ * d3;
  }
}

void LayerWaves::set_uniform(Work& work) const {
  const Index l = work.uniform_;
  const double own = (1 + 2 * l_) / 3;
  for (Index k = 0; k < layers(); ++k) {
    const double* strain = work.uniform_strain_.data() + k * components;
    Lanes* x = work.x.data() + k * components;
    x[0][l] = -strain[0];
    x[1][l] = -own * strain[1];
    x[2][l] = -strain[2];
    x[3][l] = x[4][l] = 0;
    work.mean[size(k)][l] = own * root_two_thirds * strain[1];
  }
}

}  // namespace asperity
