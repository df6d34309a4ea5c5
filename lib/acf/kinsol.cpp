#include "acf/kinsol.hpp"

#include <cmath>

#include <Eigen/Core>
#include <sundials/sundials_version.h>

#include "acf/nonlinear_system.hpp"
#include "grid/field.hpp"

namespace asperity {
namespace {

using Array = Eigen::Map<Eigen::ArrayXd>;
Array array(N_Vector v) { return {N_VGetArrayPointer(v), static_cast<Index>(N_VGetLength(v))}; }

}  // namespace

kinsol::Vector kinsol::vector_of(std::span<double> values, sundials::Context& context) {
  Vector v = made(Vector(N_VMake_Serial(static_cast<sunindextype>(values.size()), values.data(), context)),
                  "N_VMake_Serial");
  auto* operation = v->ops;
  operation->nvdotprod = [](N_Vector x, N_Vector y) { return (array(x) * array(y)).sum(); };
  operation->nvprod = [](N_Vector x, N_Vector y, N_Vector z) { array(z) = array(x) * array(y); };
  operation->nvdiv = [](N_Vector x, N_Vector y, N_Vector z) { array(z) = array(x) / array(y); };
  operation->nvabs = [](N_Vector x, N_Vector z) { array(z) = array(x).abs(); };
  operation->nvinv = [](N_Vector x, N_Vector z) { array(z) = array(x).inverse(); };
  operation->nvconst = [](sunrealtype c, N_Vector z) { array(z) = c; };
  operation->nvscale = [](sunrealtype c, N_Vector x, N_Vector z) { array(z) = c * array(x); };
  operation->nvlinearsum = [](sunrealtype a, N_Vector x, sunrealtype b, N_Vector y, N_Vector z) {
    array(z) = a * array(x) + b * array(y);
  };
  operation->nvwl2norm = [](N_Vector x, N_Vector w) {
    return std::sqrt((array(x) * array(w)).square().sum());
  };
  operation->nvmaxnorm = [](N_Vector x) { return array(x).abs().maxCoeff<Eigen::PropagateNaN>(); };
  return v;
}

std::string sundials_version() { return std::string("SUNDIALS ") + SUNDIALS_VERSION; }

}  // namespace asperity
