#!/usr/bin/env python3
"""flip_figures.py - prints the figures that metrics_test.cpp expects of FLIP, by the program of its
authors: pip install flip-evaluator==1.7. Run by hand, when the test's pictures change."""
import flip_evaluator
import numpy

PIXELS = [(5, 12), (16, 12), (17, 7), (25, 3), (31, 23), (0, 0)]


def pattern(shift):
    image = numpy.zeros((24, 32, 3), numpy.float32)
    for y in range(24):
        for x in range(32):
            image[y, x] = (x / 31, y / 23, 0.25)
            if (x - 10 - shift) ** 2 + (y - 12) ** 2 < 36:
                image[y, x] = (0.9, 0.2, 0.1)
            if x > 22 and (x + y) % 3 == 0:
                image[y, x] = (0.1 + 0.2 * shift, 0.6, 0.8)
    return image


def flip(reference, test, pixels_per_degree=None):
    parameters = {"ppd": pixels_per_degree} if pixels_per_degree else {}
    found, mean, used = flip_evaluator.evaluate(reference, test, "LDR", True, False, True, parameters)
    return found, mean, used


def main():
    black = numpy.zeros((8, 8, 3), numpy.float32)
    found, mean, used = flip(pattern(0), pattern(1))
    print("parameters", used)
    print(f"mean {mean:.6f}")
    for x, y in PIXELS:
        print(f"pixel {x}, {y}: {float(found[y, x].squeeze()):.6f}")
    print(f"mean at 30 pixels per degree {flip(pattern(0), pattern(1), 30)[1]:.6f}")
    print(f"black and white {flip(black, black + 1)[1]:.6f}")


if __name__ == "__main__":
    main()
