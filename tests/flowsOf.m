% FLOWSOF  The flows that a run of the tests takes in.
%
% CALL: [FLOWS, ALWAYS] = flowsOf (ROOT, CHANGED)
%
%   ROOT     folder of the toolbox (text)
%   CHANGED  cell of paths of files that have changed, below ROOT; {'.'}: all
%   FLOWS    1 x n cell of paths, the slowest first: those that every run of
%            the tests takes in, and those of the folders that have changed
%   ALWAYS   1 x n logical: every run of the tests takes it in
%
% tests/flows.csv has a line for each flow: its name, whether it is in every
% run (yes or no), and the folders that ask for it. A name that ends in a slash
% stands for those flows of that folder below tests/ that have no line of their own.
%
% See also: runTests

function [flows, always] = flowsOf (root, changed)
  lines = strsplit (strtrim (fileread (fullfile (root, 'tests', ...
                                                 'flows.csv'))), "\n");
  flows = cell (1, 0);
  always = false (1, 0);
  listed = strtok (lines, ',');
  for line = lines(2:end)
    cells = strsplit (line{1}, ',');
    names = setdiff (namesOf (root, cells{1}), setdiff (listed, cells{1}), 'stable');
    folders = strsplit (strtrim ([cells{3}, sprintf(' tests/%s.tst', ...
                                                    names{:})]));
    isAsked = any (strcmp (changed, '.'));
    for folder = folders
      isAsked = isAsked || any (strncmp (folder{1}, changed, ...
                                         numel (folder{1})));
    end
    if strcmp (cells{2}, 'yes') || isAsked
      flow = @(name) fullfile (root, 'tests', [name, '.tst']);
      flows = [flows, cellfun(flow, names, 'UniformOutput', false)];
      always(end + 1:numel (flows)) = strcmp (cells{2}, 'yes');
    end
  end
end

function names = namesOf (root, name)
  names = {name};
  if name(end) == '/'
    files = glob (fullfile (root, 'tests', name, '*.tst'));
    [~, names] = cellfun (@fileparts, files(:)', 'UniformOutput', false);
    names = cellfun (@(n) [name, n], names, 'UniformOutput', false);
  end
end

%!shared root
%! root = fileparts (fileparts (which ('flowsOf')));
%!test
%! % a line for each flow, and only for those that are there
%! files = [glob(fullfile (root, 'tests', '*.tst')); ...
%!          glob(fullfile (root, 'tests', '*', '*.tst'))];
%! assert (sort (flowsOf (root, {'.'})), sort (files'));
%!test
%! % the folders that the table names are there
%! words = regexp (fileread (fullfile (root, 'tests', 'flows.csv')), ...
%!                 '(?<=[, ])\w[\w/.]*(?= |$)', 'match', 'lineanchors');
%! words = setdiff (words, {'yes', 'no', 'folders'});
%! assert (numel (words) > 5);
%! assert (all (cellfun (@(f) exist (fullfile (root, f), 'file') > 0, words)));
%!test
%! added = @(file) setdiff (flowsOf (root, {file}), flowsOf (root, {}));
%! flow = @(name) {fullfile(root, 'tests', [name, '.tst'])};
%! assert (added ('VERSION'), cell (1, 0));
%! [flows, always] = flowsOf (root, {'tests/levels.tst'});
%! assert (flows(~always), flow ('levels'));
%! assert (ismember (flow ('effects'), added ('infrastructure/effects/effects.csv')));
%! assert (added ('tests/levels.tst'), flow ('levels'));

% SPDX-License-Identifier: GPL-3.0-only
