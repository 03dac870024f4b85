% SECTIONPARTICLES  Part of the report: the grains, with what was measured on them.
%
% CALL: LIST = sectionParticles (), see writePage
%       HTML = sectionParticles (PAGE, MODEL): the pictures of one model, MODEL its
%              number; '' where there are none
%
% Drawn are the dumps (readDump) that a run with the calibrated values has left,
% from the side, with the free surface and the measured inclinations of
% results.csv. pictures.csv of the case folder lays the experiment over them, at
% one scale: model, photo (file; empty: photo.jpg of the model folder), left,
% bottom, width (of the photo: m, in the coordinates of the grains), profile
% (file with a head and two columns, x and z in m: the measured surface). A photo
% without these numbers stands beside the grains.

function list = sectionParticles (page, model)
  if nargin > 1
    list = panelsOf (page, model);
    return
  end
  list = {'sectionparticles', 'Grains with these values', @particles, {}};
end

function html = particles (page)
  what = strjoin ({setsToShow(page).what}, ' or ');
  n = numel (page.Case.models);
  [htmls, areDrawn] = arrayfun (@(k) panelsOf (page, k), 1:n, 'UniformOutput', false);
  html = [htmls{:}];
  if any ([areDrawn{:}])
    html = ['<p>The last picture of a run, from the side, where one was made with ', ...
            what, '.</p>', html];
  end
end

function [html, isDrawn] = panelsOf (page, k)
  real = experimentOf (page.Case, k);
  [html, drawn] = deal ('', picturesOf (page, k, real));
  isDrawn = ~isempty (drawn);
  if ~isempty (real.photo) && ~isfinite (real.height)
    name = htmlText ([page.Case.models(k).name, ': the experiment']);
    html = ['<figure><figcaption>', name, '</figcaption><img alt="', name, ...
            '" src="', real.photo, '"></figure>'];
  end
  if ~isempty ([html, drawn])
    html = ['<div class="panels">', html, drawn, '</div>'];
  end
  if isDrawn
    key = {'line', 'red', 'free surface of the grains'; ...
           'dash', 'ink', 'measured inclination'; 'dash', 'amber', 'measured profile'};
    html = [html, htmlKey(key([true, true, ~isempty(real.profile)], :))];
  end
end

% What pictures.csv, or photo.jpg of the model folder, shows of the experiment.
function real = experimentOf (Case, k)
  real = struct ('photo', '', 'left', 0, 'bottom', 0, 'width', NaN, ...
                 'height', NaN, 'profile', []);
  photo = '';
  if ~isempty (Case.models(k).folder)
    photo = fullfile (Case.models(k).folder, 'photo.jpg');
  end
  table = fullfile (givenField (Case, 'folder', ''), 'pictures.csv');
  if isfile (table)
    [head, cells] = readCsvTable (table);
    row = strcmp (cells(:, strcmp (head, 'model')), Case.models(k).name);
    field = @(name) [cells{find(row, 1), strcmp(head, name)}, ''];
    for name = {'left', 'bottom', 'width'}
      real.(name{1}) = str2double (field (name{1}));
    end
    if ~isempty (field ('photo'))
      photo = fullfile (Case.folder, field ('photo'));
    end
    file = fullfile (Case.folder, field ('profile'));
    if ~isempty (field ('profile')) && isfile (file)
      real.profile = str2double (nthargout (2, @readCsvTable, file))(:, 1:2);
    end
  end
  if isfile (photo)
    id = fopen (photo, 'r');
    bytes = fread (id, [1, Inf], '*uint8');
    fclose (id);
    isPng = isequal (bytes(2:min (4, end)), uint8 ('PNG'));
    real.photo = ['data:image/', merge(isPng, 'png', 'jpeg'), ...
                  ';base64,', matlab.net.base64encode(bytes)];
    real.height = real.width * (imageSize (bytes) * [0; 1]) / (imageSize (bytes) * [1; 0]);
  end
end

% What was calibrated, and what was fitted together with the cause: before and
% after stand side by side.
function sets = setsToShow (page)
  sets = struct ('params', {}, 'what', {}, 'title', {});
  if ~isempty (page.found)
    sets(1) = struct ('params', page.found, 'what', page.foundWord, 'title', '');
  end
  names = page.Case.names;
  fitted = jsonAt (page.sources.gap, {'howFar', 'params'});
  if isstruct (fitted) && all (isfield (fitted, names))
    effect = char (jsonAt (page.sources.gap, {'howFar', 'effect'}));
    sets(end + 1) = struct ('params', cellfun (@(n) fitted.(n)(end), names), ...
                            'what', 'the values fitted together with the cause', ...
                            'title', [', with ', plainName(effect)]);
  end
end

function html = picturesOf (page, k, real)
  html = ['', eachOf(@(set) pictureOf (page, k, real, set), setsToShow (page)){:}];
end

function html = pictureOf (page, k, real, set)
  html = '';
  Case = page.Case;
  name = Case.models(k).name;
  slack = 1e-9 * diff (Case.limits(1:2, :));
  isShown = @(r) strcmp (r.model, name) && strcmp (r.status, 'ok') && ...
                 all (abs (r.params - set.params) < slack) && ...
                 (any (strcmp (r.stage, {'gap', 'cure'})) || ...
                  atLastLevel (r.effects, Case));
  if isempty (page.runs)
    return
  end
  run = page.runs(find (arrayfun (isShown, page.runs), 1, 'last'));
  if ~isempty (run)
    files = dir (runPlace (Case, name, run.name, '*.dump'));
    html = ['', eachOf(@(i) onePicture (fullfile (files(i).folder, files(i).name), ...
                                        Case, k, numel (files) - i, real, set.title), ...
                       1:numel (files)){:}];
  end
end

% LEFT  dumps of this run that come later
function html = onePicture (file, Case, k, left, real, note)
  [~, base] = fileparts (file);
  title = [Case.models(k).name, ': ', base, note];
  html = ['<figure><figcaption>', htmlText(title), '</figcaption>'];
  try
    grains = readDump (file){end};
  catch err                             % a dump of another form
    html = [html, '<p>No picture: ', htmlText(err.message), "</p></figure>\n"];
    return
  end
  lines = measuredLines (Case, k, file, left, grains);
  html = [html, grainPicture(grains, lines, title, real), "</figure>\n"];
end

% Grains from the side as an SVG element; LINES, cell of m x 2 (x, z), dashed on
% top, the experiment REAL over them. Of more than 3000 grains the nearest to the
% viewer are drawn.
function svg = grainPicture (grains, lines, title, real)
  [~, order] = sort (grains(:, 2), 'descend');
  grains = grains(order(max (1, end - 2999):end), :);
  corners = zeros (0, 2);
  if isfinite (real.height)
    corners = [real.left, real.bottom] + [0, 0; real.width, real.height];
  end
  extra = [vertcat(lines{:}); real.profile; corners];
  low = min ([grains(:, [1, 3]) - grains(:, 4); extra], [], 1);
  high = max ([grains(:, [1, 3]) + grains(:, 4); extra], [], 1);
  width = 340;
  scale = min ([width - 8, 260] ./ (high - low));
  height = ceil ((high(2) - low(2)) * scale) + 8;
  left = (width - (high(1) - low(1)) * scale) / 2;
  px = @(x) left + (x - low(1)) * scale;
  pz = @(z) height - 4 - (z - low(2)) * scale;
  M = [px(grains(:, 1)), pz(grains(:, 3)), grains(:, 4) * scale];
  circles = sprintf ('<circle cx="%.1f" cy="%.1f" r="%.1f"/>', M');
  photo = '';
  if ~isempty (corners)
    photo = sprintf (['<image href="%s" x="%.1f" y="%.1f" width="%.1f" height="%.1f" ', ...
                      'opacity=".55"/>'], real.photo, px (corners(1)), pz (corners(4)), ...
                     diff (corners) * scale);
  end
  x = linspace (low(1), high(1), 120);
  surface = svgPath (px (x), pz (silhouette (grains, x)));
  colours = [repmat({'ink'}, 1, numel (lines)), {'amber'}];
  dashed = '';
  lines{end + 1} = real.profile;
  for k = find (~cellfun (@isempty, lines))
    dashed = [dashed, '<path fill="none" stroke="var(--', colours{k}, ')" ', ...
              'stroke-width="2" stroke-dasharray="7 5" d="', ...
              svgPath(px (lines{k}(:, 1)), pz (lines{k}(:, 2))), '"/>'];
  end
  alt = sprintf ('%s: %d grains from the side, %.3g m wide, %.3g m high', ...
                 title, rows (grains), high - low);
  svg = sprintf (['<svg viewBox="0 0 %d %d" width="%d" height="%d" ', ...
                  'role="img" aria-label="%s"><title>%s</title>', ...
                  '<g fill="var(--midblue)" stroke="var(--blue)" ', ...
                  'stroke-width=".5">%s</g>%s<path fill="none" ', ...
                  'stroke="var(--red)" stroke-width="2" d="%s"/>%s', ...
                  '</svg>'], width, height, width, height, htmlText (alt), ...
                 htmlText (title), circles, photo, surface, dashed);
end

%!test
%! % the sample of the heap in the place of a run
%! root = fileparts (which ('DEcalioc'));
%! heap = fullfile (root, 'DEMmodels', 'Heap');
%! Case = struct ('models', struct ('name', 'Heap', 'folder', heap), ...
%!                'names', {{'a'}}, 'limits', [0; 1], 'store', tempname (), ...
%!                'coarse', [], 'folder', tempname ());
%! Case.targets = struct ('model', 1, 'index', {1, 2}, 'value', {30, 0.02});
%! folder = fullfile (Case.store, 'optim', 'Heap', '0001');
%! mkdir (folder);
%! copyfile (fullfile (heap, 'sample', 'heap.dump'), folder);
%! page.Case = Case;
%! page.runs = struct ('model', 'Heap', 'status', 'ok', 'params', 0.5, ...
%!                     'name', '0001', 'stage', 'plan', 'effects', []);
%! [page.found, page.foundWord] = deal (0.5, 'the best values so far');
%! page.sources.gap = [];
%! particles = sectionParticles (){3};
%! html = particles (page);
%! assert (numel (strfind (html, '<circle')) > 100);
%! assert (numel (strfind (html, 'stroke-dasharray')), 2);
%! % before and after, where a run was made with the cause
%! page.sources.gap = jsondecode (['{"howFar": {"effect": "tilt", ', ...
%!                                 '"params": {"a": [0.4, 0.7]}}}']);
%! page.runs(2) = setfield (setfield (page.runs, 'params', 0.7), 'stage', 'cure');
%! html = particles (page);
%! assert (numel (strfind (html, '<figure>')), 2);
%! assert (! isempty (strfind (html, 'Heap: heap, with tilt')));
%! page.sources.gap = [];
%! page.runs = page.runs(1);
%! page.runs.params = 0.6;
%! html = particles (page);
%! assert (html, '');
%! % the photo stands there with or without a run
%! page.Case.models.folder = folder;
%! writeAtomic (fullfile (folder, 'photo.jpg'), 'abc');
%! html = particles (page);
%! assert (! isempty (strfind (html, 'src="data:image/jpeg;base64,YWJj"')));
%! % with its place it lies over the grains, and so does a measured profile
%! page.runs.params = 0.5;
%! mkdir (page.Case.folder);
%! writeAtomic (fullfile (folder, 'photo.jpg'), ...
%!   char ([137, double('PNG'), 13, 10, 26, 10, 0, 0, 0, 13, double('IHDR'), 0, 0, 1, 44, ...
%!          0, 0, 0, 200, 8]));
%! writeAtomic (fullfile (page.Case.folder, 'pictures.csv'), ...
%!              ["model,photo,left,bottom,width,profile\n", ...
%!               "Heap,,-0.05,0,0.1,cone.csv\n"]);
%! writeAtomic (fullfile (page.Case.folder, 'cone.csv'), "x,z\n-0.05,0\n0,0.03\n0.05,0\n");
%! html = particles (page);
%! assert (! isempty (strfind (html, '<image href="data:image/png;base64,')));
%! assert (isempty (strfind (html, '<img')));
%! assert (! isempty (strfind (html, 'stroke="var(--amber)"')));

% SPDX-License-Identifier: GPL-3.0-only
