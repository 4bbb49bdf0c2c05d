// Draws the marks of the tools, the nib and the force as an arrow, on a canvas over the ink.

const kPixelsPerNewton = 60;
const kHalo = 1.5;  // on each side of a line, so that it shows on any ink
const kForce = '#e69f00';

export class MarksView {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.box = null;  // what the last marks covered, in CSS pixels
  }

  resize(width, height, ratio) {
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.ratio = ratio;
    this.box = null;
  }

  draw(marks, pen, paper_is_dark) {
    const { context, ratio } = this;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    if (this.box) context.clearRect(...this.box);
    this.area = [Infinity, Infinity, -Infinity, -Infinity];
    this.halo = paper_is_dark ? '#000000b0' : '#ffffffc0';
    context.lineJoin = 'round';
    for (const mark of marks) this.mark(mark);
    if (pen.known) this.pen(pen, paper_is_dark);
    context.setLineDash([]);
    const [x0, y0, x1, y1] = this.area;
    this.box = x1 < x0 ? null : [Math.floor(x0), Math.floor(y0), Math.ceil(x1 - x0) + 1, Math.ceil(y1 - y0) + 1];
  }

  cover(x, y, margin) {
    const area = this.area;
    area[0] = Math.min(area[0], x - margin);
    area[1] = Math.min(area[1], y - margin);
    area[2] = Math.max(area[2], x + margin);
    area[3] = Math.max(area[3], y + margin);
  }

  mark(mark) {
    const { context } = this, { points } = mark;
    const margin = mark.width + 2 * kHalo + (mark.radius ?? 0) + 2;
    for (let i = 0; i + 1 < points.length; i += 2) this.cover(points[i], points[i + 1], margin);
    if (mark.kind === 'label') return this.label(mark);
    context.beginPath();
    if (mark.kind === 'ring' || mark.kind === 'dot') {
      context.arc(points[0], points[1], mark.kind === 'dot' ? mark.radius ?? 3.6 : mark.radius, 0, 2 * Math.PI);
    } else {
      for (let i = 0; i + 1 < points.length; i += 2) context.lineTo(points[i], points[i + 1]);
      if (mark.closed) context.closePath();
    }
    if (mark.kind === 'dot') return this.dot(mark);
    if (mark.kind === 'arrow') this.head(points[0], points[1], points[2], points[3]);
    if (mark.kind === 'band') {
      context.setLineDash([]);
      context.lineCap = 'round';
      context.globalAlpha = 0.35;
      context.lineWidth = 2 * (mark.radius ?? 4);
      context.strokeStyle = mark.color;
      context.stroke();
      context.globalAlpha = 1;
      return;
    }
    this.stroke(mark.width, mark.color, mark.dashed);
  }

  stroke(width, color, dashed) {
    const { context } = this;
    context.lineCap = dashed ? 'butt' : 'round';
    context.setLineDash([]);
    context.lineWidth = width + 2 * kHalo;
    context.strokeStyle = this.halo;
    context.stroke();
    context.setLineDash(dashed ? [4.5, 3.6] : []);
    context.lineWidth = width;
    context.strokeStyle = color;
    context.stroke();
  }

  dot(mark) {
    const { context } = this;
    context.setLineDash([]);
    context.fillStyle = mark.color;
    context.fill();
    context.lineWidth = 1;
    context.strokeStyle = this.halo;
    context.stroke();
  }

  label(mark) {
    const { context } = this, [x, y] = mark.points;
    context.font = '12px system-ui, "DejaVu Sans", sans-serif';
    const width = context.measureText(mark.text).width + 12;
    const left = x + 12, top = y - 26;
    context.beginPath();
    context.roundRect(left, top, width, 20, 4);
    context.fillStyle = '#fffffff0';
    context.fill();
    context.setLineDash([]);
    context.lineWidth = 1;
    context.strokeStyle = '#23262d40';
    context.stroke();
    context.fillStyle = '#23262d';
    context.textBaseline = 'middle';
    context.fillText(mark.text, left + 6, top + 10.5);
    this.cover(left + width / 2, top + 10, width / 2 + 3);
  }

  head(x0, y0, x1, y1) {
    const { context } = this, length = Math.hypot(x1 - x0, y1 - y0);
    if (length < 3) return;
    const back = Math.min(9, 0.6 * length) / length, dx = (x1 - x0) * back, dy = (y1 - y0) * back;
    context.moveTo(x1 - dx - dy / 2, y1 - dy + dx / 2);
    context.lineTo(x1, y1);
    context.lineTo(x1 - dx + dy / 2, y1 - dy - dx / 2);
  }

  pen(pen, paper_is_dark) {
    const { context } = this;
    const text = paper_is_dark ? '#e6e6e3' : '#23262d';
    if (Math.hypot(pen.handX - pen.x, pen.handY - pen.y) > 2) {
      context.beginPath();
      context.moveTo(pen.handX, pen.handY);
      context.lineTo(pen.x, pen.y);
      this.stroke(1, text, false);
      this.cover(pen.handX, pen.handY, 8);
    }
    if (!pen.touching && pen.radius > 0) {
      context.beginPath();
      context.arc(pen.x, pen.y, Math.max(pen.radius, 2.5), 0, 2 * Math.PI);
      this.stroke(1, text, false);
      this.cover(pen.x, pen.y, Math.max(pen.radius, 2.5) + 6);
    }
    const { x, y } = pen.force;
    if (Math.hypot(x, y) < 0.01) return;
    const to_x = pen.x + x * kPixelsPerNewton, to_y = pen.y + y * kPixelsPerNewton;
    context.beginPath();
    context.moveTo(pen.x, pen.y);
    context.lineTo(to_x, to_y);
    this.head(pen.x, pen.y, to_x, to_y);
    this.stroke(2.4, kForce, false);
    this.cover(pen.x, pen.y, 14);
    this.cover(to_x, to_y, 14);
  }
}
