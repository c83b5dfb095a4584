"""The page of rsh-bench accuracy: the plot, what each axis is, and for the points of the front their
picture, the reference and the difference, with a slider. One file, which loads nothing."""
import base64
import html
import json
import struct
import zlib

from accuracy import front
from reporting.results import commit_of, device_text

AXES = {
    "bounces": "How many times a path may be mirrored or refracted. Longer paths end: they see what the "
               "scene says for rays that are cut, black mostly. A bounce costs the rays that it has.",
    "min_weight": "Rays whose weight in the pixel is not above this are not traced. Each saves time "
                  "and takes away at most so much of what it would have seen.",
    "tolerance": "An approximate picture: pixels between others that look alike but for this much get their "
                 "mean. What is traced has the bits of the default. It pays in larger pictures than this one.",
    "size": "Width and height of the picture that is rendered, in multiples of the default's. Larger ones "
            "are averaged down, which smooths edges; smaller ones are interpolated up.",
    "engine": "Who finds the hits. The picture has the same bits, the time does not. Each engine takes "
              "one shape of nodes over the rays: paper_faithful cones with spheres around the triangles, "
              "tiles and paper boxes.",
    "shadow": "No light is hidden by anything.",
    "reflection": "Nothing mirrors, glass neither.",
    "refraction": "Nothing lets light through.",
    "texture": "Textures count as white. The library has one filter, bilinear, so that this is all "
               "there is to choose.",
}

TEMPLATE = """<!doctype html>
<html lang="en">
<meta charset="utf-8">
<title>rsh: error against run time</title>
<link rel="icon" href="data:,">
<style>
body { font: 16px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 76em; padding: 0 1em; }
svg { max-width: 100%; height: auto; }
figure { display: inline-block; margin: 0 .6em .6em 0; width: 31%; vertical-align: top; }
figure img { width: 100%; image-rendering: pixelated; background: #888; }
input[type=range] { width: 60%; vertical-align: middle; }
dt { font-weight: 600; } dd { margin: 0 0 .5em 1.5em; }
table { border-collapse: collapse; } td, th { padding: .1em .8em; text-align: right; }
td:first-child, th:first-child { text-align: left; }
</style>
<h1>Error against run time</h1>
<p>@HEAD@</p>
<p>Each point is a way to render a scene; the default, which every other point changes in one thing, has
a ring. Up is the error: the root mean square of what a screen shows, 0 to 1, against a picture of 8 x 8
samples per pixel in double precision. No point on the black line is beaten in both time and error by
another.</p>
@SVG@
<h2>On the front</h2>
<p><label>Scene <select id="scene"></select></label>
<label>Point <input type="range" id="point" min="0" value="0"></label> <b id="name"></b></p>
<figure><img id="picture" alt="picture"><figcaption>rendered</figcaption></figure>
<figure><img id="reference" alt="reference"><figcaption>reference</figcaption></figure>
<figure><img id="difference" alt="difference"><figcaption>difference, 4 times enlarged</figcaption></figure>
<table><tr><th>ms</th><th>rmse</th><th>FLIP</th><th>wrong pixels</th><th>of the pixels that are at no edge</th></tr>
<tr id="figures"></tr></table>
<h2>Axes</h2>
<dl>@AXES@</dl>
<script>
const scenes = @DATA@;
const at = id => document.getElementById(id);
function show() {
  const scene = scenes[at("scene").value];
  const point = scene.points[at("point").value];
  at("name").textContent = point.name;
  at("picture").src = point.picture;
  at("difference").src = point.difference;
  at("reference").src = scene.reference;
  at("figures").replaceChildren(...point.figures.map(text => {
    const cell = document.createElement("td");
    cell.textContent = text;
    return cell;
  }));
}
function choose() {
  at("point").max = scenes[at("scene").value].points.length - 1;
  at("point").value = 0;
  show();
}
for (const name of Object.keys(scenes)) at("scene").add(new Option(name));
at("scene").addEventListener("change", choose);
at("point").addEventListener("input", show);
choose();
</script>
</html>
"""


def read_ppm(path):
    """As rsh-bench writes it: width, height, bytes."""
    kind, size, most, rgb = path.read_bytes().split(b"\n", 3)
    if (kind, most) != (b"P6", b"255"):
        raise SystemExit(f"{path}: must be a PPM of 8 bits, P6")
    width, height = map(int, size.split())
    return width, height, rgb


def png_chunk(kind, data):
    return (struct.pack(">I", len(data)) + kind + data +
            struct.pack(">I", zlib.crc32(kind + data)))


def data_uri(width, height, rgb):
    """As a PNG."""
    rows = b"".join(b"\0" + rgb[y * 3 * width:(y + 1) * 3 * width] for y in range(height))
    png = (b"\x89PNG\r\n\x1a\n" +
           png_chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
           png_chunk(b"IDAT", zlib.compress(rows, 9)) + png_chunk(b"IEND", b""))
    return "data:image/png;base64," + base64.b64encode(png).decode()


def difference(a, b):
    return bytes(min(255, 4 * abs(x - y)) for x, y in zip(a, b))


def figures(case):
    metrics = case["metrics"]
    return [f"{metrics['ms']:.2f}", f"{metrics['rmse']:.4f}", f"{metrics['flip']:.4f}",
            f"{100 * metrics['wrong_pixels']:.1f} %",
            f"{100 * metrics['wrong_pixels_inside']:.1f} %"]


def scene_data(scene, cases, pictures):
    width, height, truth = read_ppm(pictures / f"{scene}-truth.ppm")
    points = []
    for case in front.front(cases):
        if "picture" not in case["metrics"]:
            raise SystemExit(f"{case['name']} has no picture: run rsh-bench with --pictures")
        rgb = read_ppm(pictures / case["metrics"]["picture"])[2]
        points.append({"name": front.label(case), "figures": figures(case),
                       "picture": data_uri(width, height, rgb),
                       "difference": data_uri(width, height, difference(rgb, truth))})
    return {"reference": data_uri(width, height, truth), "points": points}


def make(results, svg, pictures):
    scenes = front.by_scene(results.cases)
    axes = {case["params"]["axis"] for case in results.cases} - {front.DEFAULT}
    texts = [f"<dt>{html.escape(name.replace('_', ' '))}</dt><dd>{html.escape(text)}</dd>"
             for name, text in AXES.items() if name in axes]
    document = results.documents[-1]
    head = f"rsh-bench accuracy: {device_text(document)}; rsh commit {commit_of(document)}"
    data = {scene: scene_data(scene, cases, pictures) for scene, cases in scenes.items()}
    return (TEMPLATE.replace("@HEAD@", html.escape(head)).replace("@SVG@", svg)
            .replace("@AXES@", "\n".join(texts)).replace("@DATA@", json.dumps(data)))
