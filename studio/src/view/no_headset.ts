// SPDX-License-Identifier: MIT
// Replaces the WebXRManager of three's renderer: the page supports no headsets.
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
