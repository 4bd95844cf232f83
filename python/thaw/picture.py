# SPDX-License-Identifier: Apache-2.0
"""Pictures of particles as shaded spheres, drawn with numpy alone. `thaw render` draws better ones."""

from __future__ import annotations

import struct
import zlib
from typing import Optional, Sequence

import numpy as np

__all__ = ['Picture', 'draw']

EMBER = ((0.30, 0.22, 0.60), (0.62, 0.20, 0.72), (0.95, 0.32, 0.42), (1.0, 0.62, 0.25), (0.98, 0.90, 0.35))
BACKGROUND = (0.93, 0.94, 0.96)
LIGHT = np.array([-0.35, 0.6, 0.72])  # right, up, toward the camera
MOST_PIXELS = 4e7  # most pixels of a picture


class Picture:
    """An image. Notebooks show it; `save(path)` writes a PNG file. pixels: uint8 (height, width, 3)."""

    def __init__(self, pixels: np.ndarray):
        self.pixels = pixels

    def png(self) -> bytes:
        """The bytes of a PNG file."""
        height, width, _ = self.pixels.shape
        rows = np.zeros((height, 1 + 3 * width), np.uint8)  # each row begins with its filter, 0
        rows[:, 1:] = self.pixels.reshape(height, -1)

        def chunk(kind: bytes, data: bytes) -> bytes:
            return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))

        head = struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)
        body = chunk(b'IHDR', head) + chunk(b'IDAT', zlib.compress(rows.tobytes(), 6)) + chunk(b'IEND', b'')
        return b'\x89PNG\r\n\x1a\n' + body

    def save(self, path: str) -> None:
        """Writes the picture as a PNG file."""
        with open(path, 'wb') as file:
            file.write(self.png())

    def _repr_png_(self) -> bytes:
        return self.png()

    def __repr__(self) -> str:
        height, width, _ = self.pixels.shape
        return f'<Picture of {width} x {height} pixels>'


def colours(values: Optional[np.ndarray], limits: Sequence[Optional[float]]) -> np.ndarray:
    """Returns colours of values between the limits; None: the lowest or highest value."""
    if values is None or len(values) == 0:
        return np.array([[0.62, 0.68, 0.76]])
    low = np.nanmin(values) if limits[0] is None else limits[0]
    high = np.nanmax(values) if limits[1] is None else limits[1]
    share = np.clip((values - low) / (high - low if high > low else 1), 0, 1)
    share = np.nan_to_num(share) * (len(EMBER) - 1)
    k = np.minimum(share.astype(int), len(EMBER) - 2)
    table, part = np.array(EMBER), (share - k)[:, None]
    return table[k] * (1 - part) + table[k + 1] * part


def distanceOf(x: np.ndarray) -> float:
    """Returns the median distance between neighbours in a sample, m."""
    sample = x[:: max(1, len(x) // 100)][:100]
    d2 = ((sample[:, None] - x[None, :: max(1, len(x) // 100000)]) ** 2).sum(axis=2)
    d2[d2 == 0] = np.inf
    nearest = np.sqrt(d2.min(axis=1))
    nearest = nearest[np.isfinite(nearest)]
    return float(np.median(nearest)) if len(nearest) else 0.01


def view(x: np.ndarray, eye: Optional[Sequence[float]], at: Optional[Sequence[float]], radius: float):
    """Returns coordinates to the right, up and toward the camera, m, and half the extent of the view, m."""
    low, high = (np.percentile(x, q, axis=0) for q in (0.1, 99.9))
    middle = (low + high) / 2 if at is None else np.asarray(at, float)
    toward = np.array([0.45, -1, 0.55]) if eye is None else np.asarray(eye, float) - middle
    toward = toward / np.linalg.norm(toward)
    up = np.array([0.0, 0, 1]) if abs(toward[2]) < 0.999 else np.array([0.0, 1, 0])
    right = np.cross(up, toward)
    right /= np.linalg.norm(right)
    axes = np.array([right, np.cross(toward, right), toward])
    seen = (x - middle) @ axes.T
    extent = np.percentile(np.abs(seen[:, :2]), 99.9, axis=0) + 2 * radius
    return seen, extent


def splat(seen: np.ndarray, rgb: np.ndarray, radius: float, size: Sequence[int]) -> np.ndarray:
    """Draws spheres. radius is in pixels; so is seen, from the middle. Returns uint8 pixels."""
    width, height = size
    depth = np.full(width * height, -np.inf)
    owner = np.full(width * height, -1)
    part = np.zeros((width * height, 2))
    column, row = np.floor(seen[:, 0] + width / 2), np.floor(height / 2 - seen[:, 1])
    reach = int(np.ceil(radius))
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            px, py = (column + dx).astype(int), (row + dy).astype(int)
            a = (px + 0.5 - width / 2 - seen[:, 0]) / radius
            b = (height / 2 - py - 0.5 - seen[:, 1]) / radius
            inside = (a * a + b * b < 1) & (px >= 0) & (px < width) & (py >= 0) & (py < height)
            k = np.flatnonzero(inside)
            if not len(k):
                continue
            front = seen[k, 2] + radius * np.sqrt(1 - a[k] ** 2 - b[k] ** 2)
            order = np.argsort(front, kind='stable')  # the last one of a pixel is the nearest
            k, front = k[order], front[order]
            pixel = py[k] * width + px[k]
            nearer = front > depth[pixel]
            k, front, pixel = k[nearer], front[nearer], pixel[nearer]
            depth[pixel], owner[pixel] = front, k
            part[pixel, 0], part[pixel, 1] = a[k], b[k]
    image = np.tile(np.array(BACKGROUND), (width * height, 1))
    hit = np.flatnonzero(owner >= 0)
    normal = np.column_stack([part[hit], np.sqrt(np.maximum(0, 1 - (part[hit] ** 2).sum(axis=1)))])
    shade = 0.42 + 0.6 * np.maximum(0, normal @ (LIGHT / np.linalg.norm(LIGHT)))
    image[hit] = np.broadcast_to(rgb, (len(seen), 3))[owner[hit]] * shade[:, None]
    return (255 * np.clip(image, 0, 1)).astype(np.uint8).reshape(height, width, 3)


def draw(
    x: np.ndarray,
    values: Optional[np.ndarray] = None,
    *,
    size: Sequence[int] = (640, 480),
    limits: Sequence[Optional[float]] = (None, None),
    eye: Optional[Sequence[float]] = None,
    at: Optional[Sequence[float]] = None,
) -> Picture:
    """Draws points x, float (n, 3), m, as spheres without perspective.

    values: (n,), for the colours between the limits; None: one colour. eye, at: points in m that give the
    direction of the view; the picture shows all points.
    """
    width, height = (int(n) for n in size)
    if min(width, height) < 16 or width * height > MOST_PIXELS:
        raise ValueError(f'a picture of {width} x {height} pixels: expected at least 16 x 16')
    if len(x) == 0:
        return Picture(np.tile((255 * np.array(BACKGROUND)).astype(np.uint8), (height, width, 1)))
    x = np.asarray(x, float)
    radius = 0.62 * distanceOf(x)
    seen, extent = view(x, eye, at, radius)
    scale = 0.95 * min(width / 2 / extent[0], height / 2 / extent[1])
    twice = 2  # drawn at twice the size, which smooths edges
    pixels = splat(
        seen * scale * twice,
        colours(values, limits),
        max(0.8, radius * scale * twice),
        (twice * width, twice * height),
    )
    smooth = pixels.reshape(height, twice, width, twice, 3).mean(axis=(1, 3))
    return Picture(smooth.round().astype(np.uint8))
