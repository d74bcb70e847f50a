/* SPDX-License-Identifier: MIT */
#include <shigusa.h>
#include <stdio.h>

/* Asks for a body: the library must have come along with the header. */
int main(void) {
  shigusa_character* human = NULL;
  shigusa_bytes* told = NULL;
  if (shigusa_abi_version() != SHIGUSA_ABI_VERSION ||
      shigusa_character_create("\"human\"", NULL, 0, &human) != SHIGUSA_OK ||
      shigusa_character_describe(human, &told) != SHIGUSA_OK) {
    fprintf(stderr, "%s\n", shigusa_message());
    return 1;
  }
  printf("%s told %zu bytes of a body\n", shigusa_version(), shigusa_bytes_size(told));
  shigusa_bytes_free(told);
  shigusa_character_free(human);
  return 0;
}
