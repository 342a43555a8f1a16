// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_block.h"

namespace ballonet::solver::contact
{

void ContactBlock::clear() { values_.fill(0); }

void ContactBlock::add_normal(bool x_is_secondary, const std::array<double, 9> &x_shapes, const PatchShapes &y_shapes,
                              const Point3 &normal, const NormalForm &form)
{
  const int x = x_is_secondary ? 0 : 9, y = 9 - x;
  std::array<double, 18> shape;                  // of x - y
  std::array<std::array<double, 18>, 2> slope{}; // of y_,0 and y_,1
  for (int a = 0; a < 9; ++a) {
    shape[x + a] = x_shapes[a];
    shape[y + a] = -y_shapes.value[a];
    slope[0][y + a] = y_shapes.derivative[0][a];
    slope[1][y + a] = y_shapes.derivative[1][a];
  }
  std::array<std::array<double, n_patch_values>, 5> product; // form times rows
  for (int k = 0; k < 5; ++k)
    for (int b = 0; b < 18; ++b) {
      const double along = slope[0][b] * form[k][3] + slope[1][b] * form[k][4];
      for (int j = 0; j < 3; ++j)
        product[k][3 * b + j] = shape[b] * form[k][j] + normal[j] * along;
    }
  for (int a = 0; a < 18; ++a)
    for (int i = 0; i < 3; ++i) {
      double *row = &patch_values_[(3 * a + i) * n_patch_values];
      const double s = shape[a], t0 = normal[i] * slope[0][a], t1 = normal[i] * slope[1][a];
      for (std::size_t j = 0; j < n_patch_values; ++j)
        row[j] += s * product[i][j] + t0 * product[3][j] + t1 * product[4][j];
    }
}

namespace
{

/// Where a node of face or patch goes in the block, with which weight.
struct Target {
  std::array<std::size_t, 3> node;
  std::array<double, 3> weight;
  int count;
};

std::array<Target, 18> targets(const Patch &patch)
{
  const auto &column = columns_behind(patch.face.local);
  std::array<Target, 18> target;
  for (std::size_t a = 0; a < 9; ++a) {
    target[a] = {{a}, {1}, 1};
    target[9 + a] = {{9u + column[3 * a], 9u + column[3 * a + 1], 9u + column[3 * a + 2]}, patch.layer_weight, 3};
  }
  return target;
}

} // namespace

void ContactBlock::spread(const Patch &primary)
{
  const auto target = targets(primary);
  for (int a = 0; a < 18; ++a)
    for (int k = 0; k < target[a].count; ++k)
      for (int i = 0; i < 3; ++i) {
        const double *from = &patch_values_[(3 * a + i) * n_patch_values];
        double *row = &values_[(3 * target[a].node[k] + i) * n_values];
        for (int b = 0; b < 18; ++b)
          for (int l = 0; l < target[b].count; ++l) {
            const double weight = target[a].weight[k] * target[b].weight[l];
            for (int j = 0; j < 3; ++j)
              row[3 * target[b].node[l] + j] += weight * from[3 * b + j];
          }
      }
  patch_values_.fill(0);
}

void ContactBlock::add_sliding(const NodeWeights &face_weights, const NodeWeights &cell_weights,
                               const dealii::Tensor<2, 3> &form)
{
  std::array<double, 36> shape;
  for (int a = 0; a < 9; ++a)
    shape[a] = face_weights[a];
  for (int b = 0; b < 27; ++b)
    shape[9 + b] = -cell_weights[b];
  std::array<std::array<double, n_values>, 3> product;
  for (int i = 0; i < 3; ++i)
    for (int b = 0; b < 36; ++b)
      for (int j = 0; j < 3; ++j)
        product[i][3 * b + j] = form[i][j] * shape[b];
  for (int a = 0; a < 36; ++a)
    for (int i = 0; i < 3; ++i) {
      double *row = &values_[(3 * a + i) * n_values];
      for (std::size_t j = 0; j < n_values; ++j)
        row[j] += shape[a] * product[i][j];
    }
}

} // namespace ballonet::solver::contact
