/// Gauss and Legendre's rule of n points on [-1, 1],
///     ∫ f(x) dx ≈ Σ w_i f(x_i),
/// exact for polynomials up to the degree 2n - 1. Nodes and weights are the doubles next to them.
#pragma once

#include <array>
#include <cstddef>

namespace asperity {

template <std::size_t n>
struct GaussLegendre {
  std::array<double, n> nodes, weights;
};

inline constexpr GaussLegendre<2> gauss2{{-0.57735026918962576, 0.57735026918962576}, {1, 1}};
inline constexpr GaussLegendre<3> gauss3{{-0.77459666924148338, 0, 0.77459666924148338},
                                         {5.0 / 9, 8.0 / 9, 5.0 / 9}};
inline constexpr GaussLegendre<4> gauss4{
    {-0.86113631159405258, -0.33998104358485626, 0.33998104358485626, 0.86113631159405258},
    {0.34785484513745386, 0.65214515486254614, 0.65214515486254614, 0.34785484513745386}};
inline constexpr GaussLegendre<8> gauss8{
    {-0.96028985649753623, -0.79666647741362674, -0.52553240991632899, -0.18343464249564980,
     0.18343464249564980, 0.52553240991632899, 0.79666647741362674, 0.96028985649753623},
    {0.10122853629037626, 0.22238103445337447, 0.31370664587788729, 0.36268378337836198, 0.36268378337836198,
     0.31370664587788729, 0.22238103445337447, 0.10122853629037626}};

}  // namespace asperity
