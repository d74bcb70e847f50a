// SPDX-License-Identifier: MIT
// A part of the C interface (shigusa.h) in C#: motions of a task, and their numbers in every frame.
using System;
using System.Runtime.InteropServices;
using System.Text;

public enum Series { Time, Angles, Torques, CentreOfMass, Support, Effectors, NodeTranslations, NodeRotations }

/// <summary>The candidates of a task, which are the best motions found. Candidates count from 1.</summary>
public sealed class Motions : IDisposable {
  const string Library = "shigusa_c"; // libshigusa_c.so, or shigusa_c.dll
  [DllImport(Library)] static extern int shigusa_check_version(uint abi, byte[] version);
  [DllImport(Library)] static extern IntPtr shigusa_message();
  [DllImport(Library)] static extern int shigusa_generate(IntPtr character, byte[] task, int threads, IntPtr watch, out IntPtr result);
  [DllImport(Library)] static extern int shigusa_result_candidates(IntPtr result);
  [DllImport(Library)] static extern int shigusa_result_describe(IntPtr result, out IntPtr json);
  [DllImport(Library)] static extern int shigusa_result_table(IntPtr result, int candidate, int series, byte[] options, out IntPtr table, out IntPtr about);
  [DllImport(Library)] static extern void shigusa_result_free(IntPtr result);
  [DllImport(Library)] static extern IntPtr shigusa_bytes_data(IntPtr bytes);
  [DllImport(Library)] static extern UIntPtr shigusa_bytes_size(IntPtr bytes);
  [DllImport(Library)] static extern void shigusa_bytes_free(IntPtr bytes);

  IntPtr result;

  /// <summary>Searches motions for the text of a task file (docs/task.schema.json).</summary>
  public Motions(string task) {
    Check(shigusa_check_version(1, Utf8("0.2.0")));
    Check(shigusa_generate(IntPtr.Zero, Utf8(task), 0, IntPtr.Zero, out result));
  }
  public int Candidates { get { return shigusa_result_candidates(result); } }
  /// <summary>Everything about the result as JSON (docs/result.schema.json).</summary>
  public string Describe() {
    IntPtr json;
    Check(shigusa_result_describe(result, out json));
    return Encoding.UTF8.GetString(Taken(json));
  }
  /// <summary>A table of frames at a rate (Hz), row by row, and its columns as JSON.</summary>
  public double[] Table(int candidate, Series series, double fps, out string about) {
    IntPtr table, text;
    var options = FormattableString.Invariant($"{{\"fps\": {fps}}}");
    Check(shigusa_result_table(result, candidate, (int)series, Utf8(options), out table, out text));
    about = Encoding.UTF8.GetString(Taken(text));
    var bytes = Taken(table);
    var values = new double[bytes.Length / sizeof(double)];
    Buffer.BlockCopy(bytes, 0, values, 0, bytes.Length);
    return values;
  }
  public void Dispose() { shigusa_result_free(result); result = IntPtr.Zero; GC.SuppressFinalize(this); }
  ~Motions() { Dispose(); }

  static byte[] Utf8(string text) { return Encoding.UTF8.GetBytes(text + "\0"); }
  static byte[] Taken(IntPtr bytes) {
    var copy = new byte[(int)shigusa_bytes_size(bytes)];
    Marshal.Copy(shigusa_bytes_data(bytes), copy, 0, copy.Length);
    shigusa_bytes_free(bytes);
    return copy;
  }
  static void Check(int status) {
    if (status == 0) return;
    var text = shigusa_message();
    var length = 0;
    while (Marshal.ReadByte(text, length) != 0) ++length;
    var message = new byte[length];
    Marshal.Copy(text, message, 0, length);
    throw new InvalidOperationException(Encoding.UTF8.GetString(message));
  }
}

/// <summary>From shigusa's axes (+Y up, ahead +Z, left +X, right-handed) to Unity's (+Y up, ahead +Z, right +X,
/// left-handed), by a mirror at x = 0, in place. It serves positions and rotations in a parent as well.</summary>
public static class UnityAxes {
  /// <summary>Rows of x, y, z.</summary>
  public static void Positions(double[] values) {
    for (var k = 0; k < values.Length; k += 3) values[k] = -values[k];
  }
  /// <summary>Rows of x, y, z, w: the mirror image of an axis, turned the other way.</summary>
  public static void Rotations(double[] values) {
    for (var k = 0; k < values.Length; k += 4) {
      values[k + 1] = -values[k + 1];
      values[k + 2] = -values[k + 2];
    }
  }
}
