% WRITEFIGURES  Writes the tables of the manual from those of the results.
%
% CALL: FAULTS = writeFigures (ROOT)
%       FAULTS = writeFigures (ROOT, true)
%
%   ROOT    folder of the toolbox; the second call only looks
%   FAULTS  1 x n cell of sentences: a page that the tables would change (second
%           call), a mark without a table or without its results, results that
%           nothing uses, or without the lines of originLines
%
% A table stands in a page (README.md, docs/, benchmarks/README.md) between
% <!-- figures: NAME --> and <!-- end of figures -->; NAME is a field of what the
% functions *Tables.m of this folder return (figureTables). figures.csv says which results (csv
% of benchmarks/results) a table needs; below each table stands what made them.
% Results whose truth was sealed (a .sha256 beside them) hold nothing but rows.
%
% See also: calibrationTables, ageOfResults

function faults = writeFigures (root, isCheck)
  results = fullfile (root, 'benchmarks', 'results');
  uses = tableRows (fullfile (root, 'benchmarks', 'figures', 'figures.csv'));
  from = struct ('tables', figureTables (), 'results', results, 'uses', {uses});
  faults = {};
  seen = {};
  for page = pagesOf (root)
    old = fileread (page{1});
    [new, names, bad] = filled (old, page{1}, from);
    name = strrep (page{1}, [root, filesep()], '');
    faults = [faults, strcat({name}, {': '}, bad)];
    seen = [seen, names];
    if nargin > 1 && isCheck && ~strcmp (old, new)
      faults{end + 1} = sprintf ('%s: a table is not that of its results: make figures', ...
                                 name);
    elseif ~strcmp (old, new)
      writeAtomic (page{1}, new);
    end
  end
  faults = [faults, unusedResults(root, from, seen)];
end

function pages = pagesOf (root)
  docs = sort (glob (fullfile (root, 'docs', '*.md')))';
  pages = [{fullfile(root, 'README.md'), fullfile(root, 'benchmarks', 'README.md')}, ...
           docs];
  pages = pages(cellfun (@isfile, pages));
end

% The text of a page with its tables made anew, their names, and what is wrong.
function [text, names, faults] = filled (text, page, from)
  pattern = '<!-- figures: (\w+) -->\n.*?<!-- end of figures -->';
  [starts, ends, found] = regexp (text, pattern, 'start', 'end', 'tokens');
  names = cellfun (@(t) t{1}, found, 'UniformOutput', false);
  faults = {};
  if numel (strfind (text, '<!-- figures:')) ~= numel (names)
    faults = {'a mark of a table has no end'};
  end
  for k = numel (names):-1:1
    isOwn = cellfun (@(u) any (strcmp (strsplit (u, ' '), names{k})), {from.uses.uses});
    files = {from.uses(isOwn).csv};
    files = files(cellfun (@(f) isfile (fullfile (from.results, [f, '.csv'])), files));
    if ~isfield (from.tables, names{k}) || isempty (files)
      faults{end + 1} = sprintf ('the mark %s has no table or no results', names{k});
      continue
    end
    read = @(csv) rowsOf (fullfile (from.results, [csv, '.csv']));
    new = sprintf ("<!-- figures: %s -->\n\n%s\n%s<!-- end of figures -->", ...
                   names{k}, from.tables.(names{k}) (read), ...
                   originText (files, from.results, page));
    text = [text(1:starts(k) - 1), new, text(ends(k) + 1:end)];
  end
end

% Results that are not there yet are no rows: a table may do without them.
function list = rowsOf (file)
  list = [];
  if isfile (file)
    list = tableRows (file);
  end
end

% A line for each table of results: what made it, when, by which code.
function text = originText (files, results, page)
  up = '';
  if isfile (fullfile (fileparts (page), 'benchmarks', 'figures.m'))
    up = 'benchmarks/';
  elseif ~isfile (fullfile (fileparts (page), 'figures.m'))
    up = '../benchmarks/';
  end
  links = cellfun (@(f) sprintf ('[%s](%sresults/%s.csv)', f, up, f), files, ...
                   'UniformOutput', false);
  said = cellfun (@(f) saidOrigin (originOf (fullfile (results, [f, '.csv']))), files, ...
                  'UniformOutput', false);
  lines = {};
  for one = unique (said(~strcmp (said, '')), 'stable')
    lines{end + 1} = sprintf ('<sub>%s: %s</sub>', strjoin (links(strcmp (said, one{1})), ...
                                                            ', '), one{1});
  end
  text = [strjoin(lines, "<br>\n"), "\n"];
end

function text = saidOrigin (head)
  text = '';
  if ~isempty (head.program)
    text = sprintf ('`%s`; %s, `%s`, %s.', head.program, head.date, head.commit, ...
                    head.machine);
    if isfinite (str2double (head.hours))
      text = [text(1:end - 1), ', ', head.hours, ' core-hours.'];
    end
  end
end

% A use is a table that stands in a page, or a program that reads the results.
function faults = unusedResults (root, from, seen)
  faults = {};
  for file = sort (glob (fullfile (from.results, '*.csv')))'
    [~, name] = fileparts (file{1});
    own = from.uses(strcmp ({from.uses.csv}, name));
    isUsed = false;
    if ~isempty (own)
      names = strsplit (own(1).uses, ' ');
      isTable = isfield (from.tables, names);
      isUsed = any (ismember (names(isTable), seen)) || ...
               any (cellfun (@(u) isProgram (root, u), names(~isTable)));
    end
    if ~isUsed
      faults{end + 1} = sprintf (['benchmarks/results/%s.csv: no table of a page and no ', ...
                                  'program uses it (benchmarks/figures/figures.csv)'], name);
    end
    isSealed = isfile ([file{1}(1:end - 4), '.sha256']);
    if ~isSealed && isempty (originOf (file{1}).program)
      faults{end + 1} = sprintf (['benchmarks/results/%s.csv: the first lines must say ', ...
                                  'what made it (originLines)'], name);
    end
  end
end

function yes = isProgram (root, name)
  places = {'', 'benches', 'form', 'leftOut', 'twins'};
  yes = any (cellfun (@(p) isfile (fullfile (root, 'benchmarks', p, [name, '.m'])), places));
end

% SPDX-License-Identifier: GPL-3.0-only
