#include "felt/base/chunked_vector.h"

#include <gtest/gtest.h>

#include <vector>

namespace felt::chunked_vector_test {
namespace {

TEST(ChunkedVector, HoldsWhatWasAppendedAcrossChunks) {
  ChunkedVector<int, 8> v;
  for (int i = 0; i < 100; ++i) v.push_back(i * i);
  ASSERT_EQ(v.size(), 100u);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(v[i], static_cast<int>(i * i));
  EXPECT_EQ(v.back(), 99 * 99);
  EXPECT_EQ(v.to_vector().size(), 100u);
}

TEST(ChunkedVector, NeverMovesAnElement) {
  ChunkedVector<int, 8> v;
  v.push_back(7);
  const int* first = &v[0];
  for (int i = 0; i < 1000; ++i) v.push_back(i);
  EXPECT_EQ(first, &v[0]);
}

TEST(ChunkedVector, KeepsItsMemoryOnClear) {
  ChunkedVector<int, 8> v;
  for (int i = 0; i < 20; ++i) v.push_back(i);
  const int* second_chunk = &v[8];
  v.clear();
  EXPECT_TRUE(v.empty());
  for (int i = 0; i < 20; ++i) v.push_back(i);
  EXPECT_EQ(second_chunk, &v[8]);
}

TEST(ChunkedVector, CopiesAndTruncates) {
  ChunkedVector<int, 4> v;
  for (int i = 0; i < 10; ++i) v.push_back(i);
  ChunkedVector<int, 4> copy = v;
  EXPECT_EQ(copy, v);
  copy.truncate(3);
  EXPECT_EQ(copy.size(), 3u);
  EXPECT_FALSE(copy == v);
  EXPECT_EQ(v.size(), 10u);
}

}  // namespace
}  // namespace felt::chunked_vector_test
