% SECTIONPARTICLES  Part of the report: the grains at the set that was found.
%
% CALL: [TITLE, HTML] = sectionParticles (PAGE)
%
%   PAGE  see pageData; TITLE, HTML  see pageSections
%
% Drawn are the dumps (readDump) that a run at the found set has left, from the
% side, with the free surface and the measured inclinations of results.csv, each
% beside photo.jpg of the model folder, if there is one.
%
% See also: pageSections, grainPicture, measuredLines

function [title, html] = sectionParticles (page)
  title = 'Grains at the set';
  html = '';
  [params, what] = setToShow (page);
  for k = 1:numel (page.Case.models)
    html = [html, photoOf(page.Case.models(k))];
    if ~isempty (params) && ~isempty (page.runs)
      html = [html, picturesOf(page, k, params)];
    end
  end
  if isempty (strfind (html, '<svg'))
    html = wrapped (html);
  else
    key = htmlKey ({'line', 'red', 'free surface, seen from the side'; ...
                    'dash', 'ink', 'measured inclination'});
    html = ['<p>The last picture of a run with ', what, ', from the side.', ...
            '</p>', key, '<div class="panels">', html, '</div>'];
  end
end

function html = wrapped (html)
  if ~isempty (html)
    html = ['<div class="panels">', html, '</div>'];
  end
end

% The experiment, where the model folder holds a photo.jpg of it.
function html = photoOf (model)
  html = '';
  file = fullfile (model.folder, 'photo.jpg');
  if isempty (model.folder) || ~isfile (file)
    return
  end
  [id, ~] = fopen (file, 'r');
  bytes = fread (id, [1, Inf], '*uint8');
  fclose (id);
  name = htmlText ([model.name, ': the experiment']);
  html = ['<figure><figcaption>', name, '</figcaption><img alt="', name, ...
          '" src="data:image/jpeg;base64,', ...
          matlab.net.base64encode(bytes), '"></figure>'];
end

function [params, what] = setToShow (page)
  params = foundSet (page);
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
  counts = arrayfun (@(r) any (strcmp (r.stage, {'gap', 'cure'})) || ...
                     atLastLevel (r.effects, Case.coarse), runs);
  runs = runs(counts);
  if isempty (runs)
    return
  end
  off = abs (vertcat (runs.params) - params) ./ diff (Case.limits);
  at = find (all (off < 1e-9, 2), 1, 'last');
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
    title = sprintf ('%s: %s', Case.models(k).name, base);
    html = ['<figure><figcaption>', htmlText(title), '</figcaption>', ...
            grainPicture(grains, lines, title), "</figure>\n"];
  catch
    % a dump of another form: no picture
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
%! page.sources = struct ('calibration', struct ('params', struct ('a', ...
%!                        0.5)), 'progress', [], 'gap', []);
%! [~, html] = sectionParticles (page);
%! assert (numel (strfind (html, '<circle')) > 100);
%! assert (numel (strfind (html, 'stroke-dasharray')), 2);
%! page.runs.params = 0.6;
%! [~, html] = sectionParticles (page);
%! assert (html, '');
%! % the photo stands there with or without a run
%! page.Case.models.folder = folder;
%! writeAtomic (fullfile (folder, 'photo.jpg'), 'abc');
%! [~, html] = sectionParticles (page);
%! assert (! isempty (strfind (html, 'src="data:image/jpeg;base64,YWJj"')));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.store, 's');
