#include "transform/single_columns.hpp"

#include <fftw3.h>

namespace {

fftwf_plan plan_of(const void* plan) { return static_cast<fftwf_plan>(const_cast<void*>(plan)); }
fftwf_complex* raw(float* p) { return reinterpret_cast<fftwf_complex*>(p); }

}  // namespace

void* asperity_plan_columns(const asperity::ColumnPlan& of, float* in, float* out) {
  return fftwf_plan_many_dft(1, &of.points, of.columns, raw(in), nullptr, 1, of.apart, raw(out), nullptr, 1,
                             of.apart, of.sign, FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
}

void asperity_execute_columns(const void* plan, float* in, float* out) {
  fftwf_execute_dft(plan_of(plan), raw(in), raw(out));
}

void asperity_destroy_columns(void* plan) { fftwf_destroy_plan(plan_of(plan)); }
