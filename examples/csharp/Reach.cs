// SPDX-License-Identifier: MIT
// Finds motions for the task of a file, and tells where the hand of each ends, in Unity's axes.
using System;
using System.Globalization;
using System.IO;

public static class Reach {
  public static int Main(string[] arguments) {
    CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
    try {
      using (var motions = new Motions(File.ReadAllText(arguments[0]))) {
        for (var k = 1; k <= motions.Candidates; ++k) {
          string about;
          var hand = motions.Table(k, Series.Effectors, 60, out about);
          var turns = motions.Table(k, Series.NodeRotations, 60, out about);
          UnityAxes.Positions(hand);
          UnityAxes.Rotations(turns);
          var end = hand.Length - 3;
          Console.WriteLine("candidate {0}: {1} frames, the hand ends at {2:F3} {3:F3} {4:F3}", k, hand.Length / 3,
            hand[end], hand[end + 1], hand[end + 2]);
        }
        if (arguments.Length > 1) File.WriteAllText(arguments[1], motions.Describe());
      }
      return 0;
    } catch (InvalidOperationException error) {
      Console.Error.WriteLine(error.Message);
      return 2;
    }
  }
}
