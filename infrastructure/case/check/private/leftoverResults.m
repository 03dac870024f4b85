% LEFTOVERRESULTS  Results that a model gives before anything has run.
%
% CALL: FOUND = leftoverResults (MODEL, NAME)
%
%   MODEL  model folder (text)
%   NAME   its name (text)
%   FOUND  1 x n struct array: index (of the result), value, file (below the
%          model folder that gives it; '': no file does, getResults returns a
%          number where there is no output). Results that follow of data.head,
%          the runscript or input scripts alone are none
%
% A run that breaks off and leaves nothing must not get the values of another
% one. getResults is asked about a fresh copy of the model, as a run folder is
% one; then files are taken away until no number is left. It may look into the
% model folder itself, so that is a copy, too. Works in the current folder,
% which it fills, and needs OctaveFuns on no path. For checkDryRunWorker.

function found = leftoverResults (model, name)
  found = struct ('index', {}, 'value', {}, 'file', {});
  places = {fullfile('optim', name, '0001'), fullfile('DEMmodels', name)};
  for place = places
    [~, ~] = mkdir (place{1});
    copyModel (place{1}, model);
  end
  funs = fullfile (pwd (), 'DEMmodels', name, 'OctaveFuns');
  addpath (funs);
  tidy = onCleanup (@() rmpath (funs));
  first = resultsOf (name);
  if ~any (isfinite (first))
    return
  end
  files = filesOf (places{1});
  isInput = cellfun (@isInputFile, files);
  files = [files(~isInput), files(isInput)];
  left = isfinite (first);
  gone = 0;
  while any (left)
    [gone, now] = takeNext (files, gone, left, places, name);
    lost = find (left & ~now);
    file = '';
    if gone > numel (files)
      lost = find (left);
    elseif gone > sum (~isInput)
      break
    else
      file = files{gone};
    end
    for k = lost
      found(end + 1) = struct ('index', k, 'value', first(k), 'file', file);
    end
    left = left & now;
    left(lost) = false;
  end
end

% The least number of files whose absence takes a result away, those that were
% taken before among them; one more than there are where none does.
function [least, now] = takeNext (files, gone, left, places, name)
  n = numel (files);
  [low, least] = deal (gone, n + 1);
  now = left;
  while low + 1 < least || (least == n + 1 && low < n)
    k = ceil ((low + least) / 2);
    k = min (k, n);
    trial = without (files, k, places, name);
    if any (left & ~trial)
      [least, now] = deal (k, trial);
    else
      low = k;
    end
  end
end

function isFinite = without (files, k, places, name)
  for place = places
    stash = [place{1}, '.stash'];
    moved = [repmat({place{1}}, 1, k), repmat({stash}, 1, numel (files) - k)];
    for i = 1:numel (files)
      to = fullfile ({stash, place{1}}{1 + (i > k)}, files{i});
      [~, ~] = mkdir (fileparts (to));
      [~, ~] = rename (fullfile (moved{i}, files{i}), to);
    end
  end
  % what an earlier call has written is no file of the model
  own = places{1};
  for extra = setdiff (filesOf (own), files)
    [~, ~] = unlink (fullfile (own, extra{1}));
  end
  isFinite = isfinite (resultsOf (name));
end

% One number a result (of a curve its first finite value), NaN for what is none.
function z = resultsOf (name)
  try
    results = getResults (name, '0001');
    if isstruct (results)
      results = struct2cell (results);
    elseif ~iscell (results)
      results = num2cell (results);
    end
    z = cellfun (@numberIn, results(:)');
  catch
    z = [];
  end
  z(end + 1:1000) = NaN;
end

function z = numberIn (value)
  z = NaN;
  if rows (value) > 1 && columns (value) == 2
    value = value(:, 2);                 % where its points lie is no result
  end
  if isnumeric (value) || islogical (value)
    z = double ([value(isfinite (value))(:); NaN])(1);
  end
end

function names = filesOf (folder)
  [~, text] = system (['cd ', shellQuote(folder), ' && find . -type f ! ', ...
                       '-path "./OctaveFuns/*" | LC_ALL=C sort']);
  names = regexp (text, '(?<=^\./)[^\n]+', 'match', 'lineanchors');
end

function yes = isInputFile (name)
  kinds = '^(data\.head|runscript|in\..*|results\.csv|.*\.(stl|inc|sh|py))$';
  yes = ~isempty (regexp (name, kinds, 'once'));
end

%!function found = ask (code, files, dirs)
%!  [model, work] = deal (tempname (), tempname ());
%!  mkdir (work);
%!  mkdir (fullfile (model, 'OctaveFuns'));
%!  code = ["function res = getResults (model, name)\nglobal path\n", ...
%!          "f = [path, 'optim/', model, '/', name, '/'];\n", code, "\nend\n"];
%!  writeAtomic (fullfile (model, 'OctaveFuns', 'getResults.m'), code);
%!  for file = [files; {'data.head', "variable a equal 4\n"}]'
%!    [~, ~] = mkdir (fileparts (fullfile (model, file{1})));
%!    writeAtomic (fullfile (model, file{1}), file{2});
%!  end
%!  here = cd (work);
%!  tidy = onCleanup (@() cd (here));
%!  found = callIt (model, work);
%!endfunction
%!function found = callIt (model, work)
%!  global path
%!  path = [work, '/'];
%!  found = leftoverResults (model, 'M');
%!  clear -global path
%!endfunction
%!shared out
%! out = 'x = load ([f, ''out''])''; res = num2cell (x);';
%!assert (isempty (ask (out, cell (0, 2))))
%!assert (isempty (ask ('res = {NaN, NaN};', {'out', '1'})))
%!test
%! % the file of a trial by hand; one result alone; a curve
%! found = ask (out, {'a', '1'; 'out', "4.29\n1.71"; 'z', '1'});
%! assert ({found.file}, {'out', 'out'});
%! assert ([found.value], [4.29, 1.71]);
%! code = ['res.w = NaN; res.c = [NaN, NaN]; ', ...
%!         'try, res.c = load ([f, ''post/c'']); end'];
%! found = ask (code, {'post/c', "1 2\n3 4"; 'post/d', 'x'});
%! assert ({found.index, found.value, found.file}, {2, 2, 'post/c'});
%! assert (isempty (ask ('res.c = [0.1, NaN; 0.5, NaN];', cell (0, 2))));
%!test
%! % two results of two files; the newest of several dumps
%! code = ['d = glob ([f, ''post/*'']); res = {NaN, NaN}; ', ...
%!         'if ~isempty (d), res{1} = numel (d); end; ', ...
%!         'try, res{2} = load ([f, ''mass'']); end'];
%! found = ask (code, {'post/1', 'x'; 'post/2', 'x'; 'mass', '3'});
%! assert ([found.index], [2, 1]);
%! assert ({found.file}, {'mass', 'post/2'});
%!test
%! % of the model folder, not of the run's; of no file; of inputs alone
%! code = 'res = {load([path, ''DEMmodels/'', model, ''/old.txt''])};';
%! assert (ask (code, {'old.txt', '7'}).file, 'old.txt');
%! code = 'res = {NaN, 0}; try, res{1} = load ([f, ''out'']); end';
%! found = ask (code, cell (0, 2));
%! assert ({found.index, found.value, found.file}, {2, 0, ''});
%! code = 'res = {str2double(fileread ([f, ''data.head''])(end - 1))};';
%! assert (isempty (ask (code, cell (0, 2))));
%! % which data.head must be there for
%! code = ['fileread ([f, ''data.head'']); ', out];
%! assert (ask (code, {'out', '5'}).file, 'out');

% SPDX-License-Identifier: GPL-3.0-only
