// SPDX-License-Identifier: MIT
#include <shigusa.h>
#include <stdio.h>
#include <stdlib.h>

static int32_t report(void* user, double fraction, int32_t evaluations, double best_score) {
  (void)user;
  fprintf(stderr, "\r%3.0f %%, %d motions, best score %.3f", 100.0 * fraction, evaluations,
          best_score);
  return 0; /* go on */
}

static void check(shigusa_status status) {
  if (status == SHIGUSA_OK) return;
  fprintf(stderr, "\nerror %d: %s\n", status, shigusa_message());
  exit(2);
}

static void write_file(const char* name, const shigusa_bytes* bytes) {
  FILE* file = fopen(name, "wb");
  const size_t size = shigusa_bytes_size(bytes);
  if (!file || fwrite(shigusa_bytes_data(bytes), 1, size, file) != size || fclose(file) != 0) {
    perror(name);
    exit(2);
  }
}

int main(void) {
  const char* task =
      "{\"goals\": [{\"effector\": \"right_hand\", \"position_m\": [-0.2, 0.4, 0.45]}]}";
  const shigusa_watch watch = {report, NULL};
  shigusa_character* human = NULL;
  shigusa_result* result = NULL;
  shigusa_bytes* bvh = NULL;

  check(shigusa_character_create("{\"source\": \"human\", \"stature_m\": 1.6}", NULL, 0, &human));
  check(shigusa_generate(human, task, 0, &watch, &result));
  fprintf(stderr, "\n");

  for (int32_t k = 1; k <= shigusa_result_candidates(result); ++k) {
    const double* hand = NULL;
    size_t frames = 0;
    size_t columns = 0;
    check(shigusa_result_series(result, k, SHIGUSA_EFFECTORS, &hand, &frames, &columns));
    hand += (frames - 1) * columns;
    printf("candidate %d: %zu frames, the hand ends at %.4f %.4f %.4f m\n", k, frames, hand[0],
           hand[1], hand[2]);
  }
  check(shigusa_result_export(result, 1, "bvh", &bvh));
  write_file("reach.bvh", bvh);

  shigusa_bytes_free(bvh);
  shigusa_result_free(result);
  shigusa_character_free(human);
  return 0;
}
