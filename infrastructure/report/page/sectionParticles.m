% SECTIONPARTICLES  Part of the report: the grains at the set that was found.
%
% CALL: LIST = sectionParticles (), see writePage
%
% Drawn are the dumps (readDump) that a run at the found set has left, from the
% side, with the free surface and the measured inclinations of results.csv, each
% beside photo.jpg of the model folder, if there is one.

function list = sectionParticles ()
  list = {'sectionparticles', 'Grains at the set', @particles, {}};
end

function html = particles (page)
  html = '';
  [params, what] = setToShow (page);
  for k = 1:numel (page.Case.models)
    html = [html, photoOf(page.Case.models(k))];
    if ~isempty (params) && ~isempty (page.runs)
      html = [html, picturesOf(page, k, params)];
    end
  end
  lead = '';
  if ~isempty (strfind (html, '<svg'))
    lead = ['<p>The last picture of a run with ', what, ', from the side.', ...
            '</p>', htmlKey({'line', 'red', ...
                             'free surface, seen from the side'; ...
                             'dash', 'ink', 'measured inclination'})];
  end
  if ~isempty (html)
    html = [lead, '<div class="panels">', html, '</div>'];
  end
end

% The experiment, where the model folder holds a photo.jpg of it.
function html = photoOf (model)
  html = '';
  file = fullfile (model.folder, 'photo.jpg');
  if isempty (model.folder) || ~isfile (file)
    return
  end
  id = fopen (file, 'r');
  bytes = fread (id, [1, Inf], '*uint8');
  fclose (id);
  name = htmlText ([model.name, ': the experiment']);
  html = ['<figure><figcaption>', name, '</figcaption><img alt="', name, ...
          '" src="data:image/jpeg;base64,', ...
          matlab.net.base64encode(bytes), '"></figure>'];
end

function [params, what] = setToShow (page)
  params = page.found;
  what = 'the set that was found';
  names = page.Case.names;
  fitted = jsonAt (page.sources.gap, {'howFar', 'params'});
  if isempty (params) && isstruct (fitted) && all (isfield (fitted, names))
    params = cellfun (@(n) fitted.(n)(end), names);
    what = 'the parameters fitted together with the effect';
  end
end

function html = picturesOf (page, k, params)
  html = '';
  Case = page.Case;
  name = Case.models(k).name;
  runs = page.runs(strcmp ({page.runs.model}, name) & ...
                   strcmp ({page.runs.status}, 'ok'));
  slack = 1e-9 * diff (Case.limits(1:2, :));
  isAtSet = @(r) all (abs (r.params - params) < slack);
  counts = @(r) any (strcmp (r.stage, {'gap', 'cure'})) || ...
                atLastLevel (r.effects, Case.coarse);
  at = find (arrayfun (@(r) isAtSet (r) && counts (r), runs), 1, 'last');
  if isempty (at)
    return
  end
  folder = fullfile (Case.store, 'optim', name, runs(at).name);
  files = dir (fullfile (folder, '*.dump'));
  for i = 1:numel (files)
    html = [html, onePicture(fullfile (folder, files(i).name), Case, k, ...
                             numel (files) - i)];
  end
end

% LEFT  dumps of this run that come later
function html = onePicture (file, Case, k, left)
  html = '';
  try
    grains = readDump (file){end};
    lines = measuredLines (Case, k, file, left, grains);
    [~, base] = fileparts (file);
    title = [Case.models(k).name, ': ', base];
    html = ['<figure><figcaption>', htmlText(title), '</figcaption>', ...
            grainPicture(grains, lines, title), "</figure>\n"];
  catch
    % a dump of another form: no picture
  end
end

% Grains from the side as an SVG element; LINES, cell of m x 2 (x, z), dashed on
% top. Of more than 3000 grains the nearest to the viewer are drawn.
function svg = grainPicture (grains, lines, title)
  [~, order] = sort (grains(:, 2), 'descend');
  grains = grains(order(max (1, end - 2999):end), :);
  low = min ([grains(:, [1, 3]) - grains(:, 4); vertcat(lines{:})], [], 1);
  high = max ([grains(:, [1, 3]) + grains(:, 4); vertcat(lines{:})], [], 1);
  width = 340;
  scale = min ([width - 8, 260] ./ (high - low));
  height = ceil ((high(2) - low(2)) * scale) + 8;
  left = (width - (high(1) - low(1)) * scale) / 2;
  px = @(x) left + (x - low(1)) * scale;
  pz = @(z) height - 4 - (z - low(2)) * scale;
  M = [px(grains(:, 1)), pz(grains(:, 3)), grains(:, 4) * scale];
  circles = sprintf ('<circle cx="%.1f" cy="%.1f" r="%.1f"/>', M');
  x = linspace (low(1), high(1), 120);
  surface = pathOf (px (x), pz (silhouette (grains, x)));
  dashed = '';
  for k = 1:numel (lines)
    dashed = [dashed, '<path fill="none" stroke="var(--ink)" ', ...
              'stroke-width="2" stroke-dasharray="7 5" d="', ...
              pathOf(px (lines{k}(:, 1)), pz (lines{k}(:, 2))), '"/>'];
  end
  alt = sprintf ('%s: %d grains from the side, %.3g m wide, %.3g m high', ...
                 title, rows (grains), high - low);
  svg = sprintf (['<svg viewBox="0 0 %d %d" width="%d" height="%d" ', ...
                  'role="img" aria-label="%s"><title>%s</title>', ...
                  '<g fill="var(--midblue)" stroke="var(--blue)" ', ...
                  'stroke-width=".5">%s</g><path fill="none" ', ...
                  'stroke="var(--red)" stroke-width="2" d="%s"/>%s', ...
                  '</svg>'], width, height, width, height, htmlText (alt), ...
                 htmlText (title), circles, surface, dashed);
end

% A line that is broken where there is nothing.
function text = pathOf (x, y)
  text = '';
  pen = 'M';
  for k = 1:numel (x)
    if isfinite (y(k))
      text = [text, sprintf('%s%.1f %.1f', pen, x(k), y(k))];
      pen = 'L';
    else
      pen = 'M';
    end
  end
end

%!test
%! % the sample of the heap in the place of a run
%! root = fileparts (which ('DEcalioc'));
%! heap = fullfile (root, 'DEMmodels', 'Heap');
%! Case = struct ('models', struct ('name', 'Heap', 'folder', heap), ...
%!                'names', {{'a'}}, 'limits', [0; 1], 'store', tempname (), ...
%!                'coarse', []);
%! Case.targets = struct ('model', 1, 'index', {1, 2}, 'value', {30, 0.02});
%! folder = fullfile (Case.store, 'optim', 'Heap', '0001');
%! mkdir (folder);
%! copyfile (fullfile (heap, 'sample', 'heap.dump'), folder);
%! page.Case = Case;
%! page.runs = struct ('model', 'Heap', 'status', 'ok', 'params', 0.5, ...
%!                     'name', '0001', 'stage', 'plan', 'effects', []);
%! page.found = 0.5;
%! page.sources.gap = [];
%! particles = sectionParticles (){3};
%! html = particles (page);
%! assert (numel (strfind (html, '<circle')) > 100);
%! assert (numel (strfind (html, 'stroke-dasharray')), 2);
%! page.runs.params = 0.6;
%! html = particles (page);
%! assert (html, '');
%! % the photo stands there with or without a run
%! page.Case.models.folder = folder;
%! writeAtomic (fullfile (folder, 'photo.jpg'), 'abc');
%! html = particles (page);
%! assert (! isempty (strfind (html, 'src="data:image/jpeg;base64,YWJj"')));
