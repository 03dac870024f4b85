% SAYIMPORT  Shows how a table of runs is understood, before anything is run.
%
% CALL: STATUS = sayImport (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text);  FOLDER  case folder (text)
%   ARGS    cell of texts: path of the table; --column THEIRS=OURS (many) says what
%           a column is to the case; --take writes the table as runs.csv
%   STATUS  0; 2 where the case takes none of its rows
%
% Without --take nothing is written: as runs.csv in the case folder the table is
% taken in.
%
% Errors: DEcalioc:sayImport:badValue (--column), :exists (runs.csv); those of
% commandOptions, caseToRead and importRuns, which say what is
% to be mended

function status = sayImport (root, folder, args)
  [given, words] = commandOptions (args, struct ('column', 'many', 'take', 'flag'));
  file = words{1};
  Case = caseToRead (root, folder);
  Case.columns = pairsOf (given.column);
  checkPairs (file, Case);
  data = importRuns (file, Case);
  [table, spread] = readRunsTable (file, Case);
  cells = table.cells;
  printf ('table     %s: %s, %s\n\n', file, countText (rows (cells), 'row'), ...
          countText (columns (cells), 'column'));
  sayRow ('column', 'is', 'numbers', 'lowest', 'highest', 'first row');
  for k = 1:numel (table.names)
    sayColumn (table.header{k}, whatIs (table.names{k}, table.kinds{k}, Case), ...
               cells(:, k));
  end
  [~, isIn] = insideLimits (data.X, Case.limits);
  isPlain = all (data.E == neutralEffects (Case), 2);
  printf ('\nsets      %d; %d of them between the limits of the case', ...
          rows (data.X), sum (isIn));
  printf ('%s\n', repmat (sprintf (', %d with an effect', sum (~isPlain)), 1, ...
                          any (~isPlain)));
  sayResults (data.Z, Case.targets);
  sayUnits (Case.targets, data.Z, 'in the middle of these runs');
  target = fullfile (folder, 'runs.csv');
  if given.take
    take (spread, target);
  elseif ~isempty (given.column)
    printf (['\nNext: the same with --take writes it as %s, with the names of ' ...
             'the case. decalioc run takes it in.\n'], target);
  elseif ~strcmp (make_absolute_filename (file), target)
    printf ('\nNext: copy it to %s. decalioc run takes it in.\n', target);
  end
  if ~any (isIn)
    printf (['\nNone of these sets lies between the limits of the case: compare lowest and ' ...
             'highest with paramLims.\n']);
  end
  status = 2 * ~any (isIn);
end

% Of texts THEIRS=OURS.
function pairs = pairsOf (texts)
  pairs = cell (0, 2);
  for text = texts
    at = find (text{1} == '=', 1, 'last');
    pair = strtrim ({text{1}(1:at - 1), text{1}(at + 1:end)});
    if isempty (at) || any (cellfun (@isempty, pair))
      error ('DEcalioc:sayImport:badValue', ...
             ['--column must be given as THEIRS=OURS, a column of the table and ' ...
              'what it is to the case (--column "mu 1"=friction), got %s.'], text{1});
    end
    pairs(end + 1, :) = pair;
  end
end

function checkPairs (file, Case)
  if isempty (Case.columns)
    return
  end
  table = readRunsTable (file, Case);
  heads = [table.header; regexprep(table.header, '\s*[[(][^])]*[])]$', '')];
  for pair = Case.columns'
    k = find (any (strcmp (heads, pair{1}), 1), 1);
    if isempty (k)
      error ('DEcalioc:sayImport:badValue', ...
             '--column must name a column of the table, got %s. It has: %s. %s', ...
             pair{1}, strjoin (table.header, ', '), ...
             checkNearest (pair{1}, table.header));
    elseif strcmp (table.kinds{k}, 'ignored')
      error ('DEcalioc:sayImport:badValue', ...
             ['--column %s must be a parameter, an effect or a result of the case, ' ...
              'got %s.'], pair{1}, pair{2});
    end
  end
end

function take (table, target)
  if isfile (target)
    error ('DEcalioc:sayImport:exists', ...
           '%s is there already. Nothing is overwritten; move it away first.', target);
  end
  isKnown = ~strcmp (table.kinds, 'ignored');
  lines = num2cell ([table.names(isKnown); table.cells(:, isKnown)], 2);
  lines = cellfun (@csvLine, lines, 'UniformOutput', false);
  writeAtomic (target, sprintf ('%s\n', lines{:}));
  printf ('\nwritten   %s, which decalioc run takes in\n', target);
end

function sayResults (Z, targets)
  for t = 1:numel (targets)
    hasOthers = any (isfinite (Z(:, [targets.model] == targets(t).model)), 2);
    open = sum (isna (Z(:, t)) & hasOthers);
    left = sprintf (', %d not run for it (empty beside other results)', open);
    printf ('          %s: %s, %d without one%s\n', targets(t).name, ...
            countText (sum (isfinite (Z(:, t))), 'result'), ...
            sum (isnan (Z(:, t)) & ~isna (Z(:, t))), ...
            repmat (left, 1, open > 0));
  end
end

function sayColumn (name, what, texts)
  values = str2double (texts);
  values = values(isfinite (values));
  ends = {'', ''};
  if ~isempty (values)
    ends = {sprintf('%g', min (values)), sprintf('%g', max (values))};
  end
  first = '';
  if ~isempty (texts)
    first = texts{1};
  end
  sayRow (name, what, sprintf ('%d', numel (values)), ends{:}, first);
end

function sayRow (varargin)
  printf ('  %-22s %-30s %8s %10s %10s  %s\n', varargin{:});
end

% In words, with the measured value of a result.
function text = whatIs (name, kind, Case)
  text = kind;
  switch kind
    case 'ignored'
      text = 'not known to the case: not used';
      if any (strcmp (name, {Case.fixed.name}))
        text = 'parameter, not varied by itself';
      end
    case 'trial'
      text = ['a run of ', name];
    case 'runs'
      text = 'runs that a row is the mean of';
    case 'scatter'
      text = ['scatter of these runs, ', name];
    case 'result'
      T = Case.targets(find (strcmp (name, {Case.targets.name}), 1));
      text = sprintf ('result, measured %g', T.value);
      if Case.isCost
        text = 'cost: the smallest counts';
      end
  end
end

%!test
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! writeAtomic (fullfile (raw.folder, 'my runs.csv'), ...
%!              ["model;a [m];b;First_1;First_2;note\n", ...
%!               "First;0,5;0,2;3;n/a;x\nFirst;0,6;90;3;4;y\n"]);
%! command = ['cd ', shellQuote(raw.folder), ' && ', ...
%!            shellQuote(fullfile (fileparts (fileparts (which ('startToolbox'))), ...
%!                                 'bin', 'decalioc'))];
%! [status, out] = system ([command, ' import ''my runs.csv'' . 2>&1']);
%! assert (status == 0, out);
%! for part = {'a \[m\] +parameter +2 +0.5 +0.6', 'First_1 +result, measured', ...
%!             'note +not known to the case', 'sets +2; 1 of them between', ...
%!             'First_2: 1 result, 0 without one, 1 not run for it', 'copy it to '}
%!   assert (! isempty (regexp (out, part{1}, 'once')), out);
%! end
%! assert (! isfile (fullfile (raw.folder, 'runs.csv')));
%! % columns of other names; taken in with the names of the case
%! writeAtomic (fullfile (raw.folder, 'my runs.csv'), ...
%!              ["model;Reibung [-];b;First_1;First_2\nFirst;0,5;0,2;3;4\n"]);
%! [status, out] = system ([command, ' import ''my runs.csv'' . --column ', ...
%!                          'Reibung=a --take 2>&1']);
%! assert (status == 0, out);
%! assert (fileread (fullfile (raw.folder, 'runs.csv')), ...
%!         "model,a,b,First_1,First_2\nFirst,0.5,0.2,3,4\n");
%! here = cd (raw.folder);
%! back = onCleanup (@() cd (here));
%! clear loadInput
%! for row = {'Reibung=a --take', 'is there already'; 'Reibung', 'THEIRS=OURS'; ...
%!            'Reib=a', 'It has: model, Reibung [-], b'; 'Reibung=q', 'got q'}'
%!   out = '';
%!   try
%!     words = [{fullfile(raw.folder, 'my runs.csv'), '--column'}, strsplit(row{1}, ' ')];
%!     evalc ('sayImport (raw.root, raw.folder, words)');
%!   catch err
%!     out = err.message;
%!   end
%!   assert (! isempty (strfind (out, row{2})), out);
%! end

% SPDX-License-Identifier: GPL-3.0-only
