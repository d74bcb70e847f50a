// SPDX-License-Identifier: MIT
// A turned vector in Unity's axes is the vector in Unity's axes, turned there: the mirror of both.
using System;

public static class UnityAxesTest {
  // v turned by q = (x, y, z, w), by the same formula in either handedness.
  static double[] Turned(double[] q, double[] v) {
    var t = new[] {
      2 * (q[1] * v[2] - q[2] * v[1]), 2 * (q[2] * v[0] - q[0] * v[2]), 2 * (q[0] * v[1] - q[1] * v[0]),
    };
    return new[] {
      v[0] + q[3] * t[0] + q[1] * t[2] - q[2] * t[1],
      v[1] + q[3] * t[1] + q[2] * t[0] - q[0] * t[2],
      v[2] + q[3] * t[2] + q[0] * t[1] - q[1] * t[0],
    };
  }

  public static int Main() {
    var random = new Random(1);
    for (var n = 0; n < 1000; ++n) {
      var q = new double[4];
      var v = new double[3];
      var length = 0.0;
      for (var k = 0; k < 4; ++k) { q[k] = random.NextDouble() - 0.5; length += q[k] * q[k]; }
      for (var k = 0; k < 4; ++k) q[k] /= Math.Sqrt(length);
      for (var k = 0; k < 3; ++k) v[k] = random.NextDouble() - 0.5;
      var there = Turned(q, v);
      UnityAxes.Positions(there);
      UnityAxes.Rotations(q);
      UnityAxes.Positions(v);
      var here = Turned(q, v);
      for (var k = 0; k < 3; ++k) {
        if (Math.Abs(here[k] - there[k]) < 1e-12) continue;
        Console.Error.WriteLine("turn {0}: {1} and not {2}", n, here[k], there[k]);
        return 1;
      }
    }
    return 0;
  }
}
