// SPDX-License-Identifier: MIT
// Three's renderer has this class in the place of its WebXRManager: nobody looks at this page through a headset.
const nothing = (): void => undefined;

export class WebXRManager {
  readonly enabled = false;
  readonly isPresenting = false;
  readonly addEventListener = nothing;
  readonly removeEventListener = nothing;
  readonly setAnimationLoop = nothing;
  readonly dispose = nothing;
  readonly getEnvironmentBlendMode = nothing;
}
