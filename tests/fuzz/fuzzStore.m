% FUZZSTORE  Lets a store lie, and reports what a case on it makes of that.
%
% CALL: [FAILURES, COUNT] = fuzzStore (N, SEED)
%
%   N         number of lies, one at a time;  SEED  of the random numbers
%   FAILURES  1 x m cell of texts, one a failure
%   COUNT     scalar struct, number of the lies about: index, record, surrogate;
%             said (of these, which changed the samples, and were reported)
%
% Bytes are changed, left out, put twice; an index, a record or a surrogate is
% replaced by code for Octave's load; fields of a record, whose checksum is right
% again, are of another kind, size or value. A failure is code that was carried
% out, an error without an identifier of DEcalioc, a sample that no run has
% given, and one that is missing though libraryRuns reports nothing passed over.

function [failures, count] = fuzzStore (n, seed)
  rand ('twister', seed);
  failures = {};
  count = struct ('index', 0, 'record', 0, 'surrogate', 0, 'said', 0);
  lab = newLab ();
  for i = 1:n
    kinds = {'index', 'record', 'surrogate'};
    what = kinds{1 + floor(3 * rand ())};
    count.(what) = count.(what) + 1;
    files = lab.(what);
    file = files{1 + floor(rand () * numel (files))};
    whole = readBytes (file);
    how = tell (file, whole, lab.flag, strcmp (what, 'record'));
    [text, isSaid] = looked (what, file, lab);
    count.said = count.said + isSaid;
    if ~isempty (text)
      failures{end + 1} = sprintf ('%d, %s of %s: %s', i, how, file, text);
    end
    writeBytes (file, whole);
  end
end

function lab = newLab ()
  first = newCase (standInCase (tempname ()));
  evaluateDEM ([1, 2; 3, 4; 5, 6; 9, 9], first, [1; 1; 1; 2]);
  raw = standInCase (tempname ());
  raw.Input.store = first.store;
  lab.Case = newCase (raw);
  lab.problem = newProblem (lab.Case);
  lab.flag = tempname ();
  lab.samples = samplesOf (lab);
  place = @(model, name) fullfile (first.store, 'optim', model, name);
  index = sprintf ('.index-%d', geteuid ());
  lab.index = {place('First', index), place('Second', index)};
  lab.record = glob (place ('*', '0*/record.json'))';
  X = rand (8, 2);
  lab.surrogate = {tempname()};
  saveSurrogate (lab.surrogate{1}, ...
                 fitSurrogate (X, X * [1; 2], [0, 0; 1, 1], ...
                               struct ('trend', 'affine', ...
                                       'covariance', 'matern52')));
end

% One number a row: model, parameters, results.
function [list, tally] = samplesOf (lab)
  [~, ~] = unlink (fullfile (lab.Case.folder, 'results', 'library.csv'));
  [data, tally] = libraryRuns (lab.Case, lab.problem);
  list = zeros (0, 6);
  for k = 1:2
    own = [lab.Case.targets.model] == k;
    z = NaN (numel (data.replicate), 3);
    z(:, own) = data.Z(:, own);
    isRun = ~any (isna (data.Z(:, own)), 2);
    list = [list; k * ones(sum (isRun), 1), data.X(isRun, :), z(isRun, :)];
  end
  list(isnan (list)) = -99;
end

% Lies about a file; HOW says in which way.
function how = tell (file, bytes, flag, isRecord)
  ways = {'a byte', 'left out', 'twice', 'code', 'cut', 'field', 'field'};
  how = ways{1 + floor((5 + 2 * isRecord) * rand ())};
  at = sort (1 + floor (rand (1, 2) * numel (bytes)));
  switch how
    case 'a byte'
      bytes(at(1)) = uint8 (floor (256 * rand ()));
    case 'left out'
      bytes(at(1):at(2)) = [];
    case 'twice'
      bytes = [bytes(1:at(2)), bytes(at(1):end)];
    case 'cut'
      bytes = bytes(1:at(1));
    case 'code'
      bytes = uint8 (["# Created by Octave\n# name: kept\n", ...
                      "# type: function handle\n@<anonymous>\nsystem('", ...
                      'touch ', flag, "')\n\n"]);
    otherwise
      how = lieIn (file);
      return
  end
  writeBytes (file, bytes);
end

% What its key proves, or its form: results are what the record says.
function how = lieIn (file)
  r = readRecord (file);
  names = {'model', 'params', 'effects', 'replicate', 'seed', 'key', ...
           'input', 'variables', 'origin', 'owner', 'status', 'results', ...
           'seconds', 'funs', 'readings'};
  name = names{1 + floor(rand () * numel (names))};
  values = {'', 'x', "\n", 1, [], [1; 2], struct('a', 1), {{1}}, true, ...
            repmat('a', 1, 64), NaN, Inf, '|a=1|b=2', struct('status', 'ok')};
  if any (strcmp (name, {'replicate', 'seconds', 'status', 'results', 'funs', ...
                         'origin'}))
    values = values([3, 5:9, 14]);      % of no kind that it may have
  end
  value = values{1 + floor(rand () * numel (values))};
  how = sprintf ('field %s (%s)', name, class (value));
  if rand () < 0.2
    r = rmfield (r, intersect (fieldnames (r), {name}));
  else
    r.(name) = value;
  end
  writeLie (file, r);
end

% As writeRecord, which takes no readings that are none.
function writeLie (file, r)
  isPlain = ~isfield (r, 'readings') || isstruct (r.readings);
  if isPlain
    writeRecord (file, r);
    return
  end
  writeRecord (file, rmfield (r, 'readings'));
  body = regexp (fileread (file), '"record":(\{.*)\}\}\n$', 'tokens', ...
                 'once'){1};
  body = [body, ',"readings":', jsonencode(r.readings), '}'];
  writeBytes (file, uint8 (sprintf ('{"sha256":"%s","record":%s}\n', ...
                                    hash ('sha256', body), body)));
end

function [text, isSaid] = looked (what, file, lab)
  [text, isSaid] = deal ('', false);
  try
    if strcmp (what, 'surrogate')
      loadSurrogate (file);
    else
      [text, isSaid] = judged (lab);
    end
  catch err
    if ~strncmp (err.identifier, 'DEcalioc:', 9)
      text = sprintf ('raw error %s @%s', err.message, err.stack(1).name);
    end
  end
  if isfile (lab.flag)
    text = [text, ' CODE WAS CARRIED OUT'];
    unlink (lab.flag);
  end
end

function [text, isSaid] = judged (lab)
  text = '';
  [found, tally] = samplesOf (lab);
  jobs = newJobs (lab.Case, [1, 2; 9, 9], [], 1, 'plan');
  findRuns (jobs, lab.Case);
  runsOfCase (lab.Case);
  isFalse = ~ismember (found, lab.samples, 'rows');
  isLess = rows (found) < rows (lab.samples);
  isSaid = isLess && ~(isempty (tally.passed) && isempty (tally.other));
  if any (isFalse)
    text = ['false sample ', mat2str(found(find (isFalse, 1), :), 4)];
  elseif isLess && ~isSaid
    text = 'a sample is missing without a word';
  end
end

function bytes = readBytes (file)
  fid = fopen (file, 'r');
  bytes = fread (fid, Inf, 'uint8=>uint8')';
  fclose (fid);
end

function writeBytes (file, bytes)
  fid = fopen (file, 'w');
  fwrite (fid, bytes);
  fclose (fid);
end

% SPDX-License-Identifier: GPL-3.0-only
