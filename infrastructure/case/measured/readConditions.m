% READCONDITIONS  Reads measured.csv, and beside it that of an earlier case.
%
% CALL: [LIST, FAULTS] = readConditions (RAW, MODELS)
%       [LIST, FAULTS] = readConditions (RAW, MODELS, 'further')
%
%   RAW     struct of readInput: folder, and Input, of which reference names the
%           folder of an earlier case ('': none)
%   MODELS, LIST, FAULTS  see readMeasured
%
% After measured.csv come the lines with a value of the tests in RAW.further
% (readInput); with 'further' these are all. A line that names no model is of
% the test, or of the one model of the case besides the tests.
%
% With a reference the lines of that case (of its own reference, where it has
% conditions) come first, as the condition reference; the others are the
% condition now. A monday of that case is another one than that of this.

function [list, p] = readConditions (raw, models, which)
  [further, p] = furtherLines (raw, models);
  list = further;
  if nargin > 2
    return
  end
  own = find (~ismember (models, givenField (raw, 'further', {})));
  own = sum (own(isscalar (own)));
  [list, q] = readChecked (raw.folder, models, own, 'measured.csv');
  p = [q, p];
  if ~isempty (list)
    list = [list, further];
  end
  reference = givenField (raw.Input, 'reference', '');
  if ~ischar (reference) || isempty (reference) || isempty (list)
    return
  end
  if ~all (cellfun (@isempty, {list.condition}))
    p(end + 1) = checkFault ('measuredCondition', 'Input.reference', ...
                             ['nothing, for measured.csv has the column ' ...
                              'condition'], describeValue (reference), ...
                             'Take one of the two out.');
    return
  end
  folder = canonicalize_file_name (tilde_expand (reference));
  if isequal (folder, canonicalize_file_name (raw.folder))
    p(end + 1) = checkFault ('measuredCondition', 'Input.reference', ...
                             'the folder of another case', describeValue (reference), ...
                             'A case is no reference of its own.');
    return
  end
  [before, q] = readChecked (tilde_expand (reference), models, own, ...
                             fullfile (reference, 'measured.csv'));
  p = [p, q];
  if ~isempty (before)
    before = before(ismember ({before.condition}, {'', 'reference'}));
    [before.condition] = deal ('reference');
    for k = find (~cellfun (@isempty, {before.session}))
      before(k).session = [before(k).session, ' (reference)'];
    end
    [list.condition] = deal ('now');
    list = [before, list];
  end
end

% In a column condition one is the reference, there is another one, and no line
% is without.
function [list, p] = readChecked (folder, models, own, shown)
  [list, p, header] = readMeasured (fullfile (folder, 'measured.csv'), ...
                                    models, own, shown);
  if isempty (list) || ~any (strcmp (header, 'condition'))
    return
  end
  conditions = {list.condition};
  isName = cellfun (@isConditionName, conditions);
  for k = find (~isName)
    p(end + 1) = checkFault ('measuredCondition', ...
                             sprintf ('%s, line %d, condition', shown, ...
                                      list(k).line), ...
                             ['a name of letters, digits, spaces and _ - + . ( ) %, not ' ...
                              'next; reference where nothing has changed yet'], ...
                             describeValue (conditions{k}), ...
                             'Or take the column out of the table.');
  end
  [~, first, kind] = unique (lower (conditions), 'first');
  for k = find (isName & ~strcmp (conditions, conditions(first(kind))))
    p(end + 1) = checkFault ('measuredCondition', ...
                             sprintf ('%s, line %d, condition', shown, list(k).line), ...
                             'one way to write a name', ...
                             sprintf ('%s beside %s', conditions{k}, ...
                                      conditions{first(kind(k))}), ...
                             'Write it alike in all lines.');
  end
  isReference = strcmp (conditions, 'reference');
  if all (isName) && (all (isReference) || ~any (isReference))
    p(end + 1) = checkFault ('measuredCondition', ...
                             [shown, ', condition'], ...
                             'reference and at least one other condition', ...
                             strjoin (unique (conditions), ', '), ...
                             ['Call reference what was measured before the ' ...
                              'change, and the rest by names of your own.']);
  end
end

% Its files lie in a folder of this name, beside others of gap/.
function yes = isConditionName (name)
  yes = isKind ('folder', regexprep (name, '[ ()%]', '_')) && ...
        ~any (strcmp (name, {'next', 'gap.json', 'calibrated.head'}));
end

function [list, p] = furtherLines (raw, models)
  list = [];
  p = checkFault ();
  for name = givenField (raw, 'further', {})
    file = fullfile ('gap', 'next', [name{1}, '.csv']);
    [own, q] = readMeasured (fullfile (raw.folder, file), models, ...
                             sum (find (strcmp (models, name{1}), 1)), file);
    p = [p, q];
    if ~isempty (own)
      list = [list, own(isfinite ([own.value]))];
    end
  end
end

%!function [list, reasons] = read (reference, varargin)
%!  % the last table is that of the case
%!  for k = 1:numel (varargin)
%!    folders{k} = tempname ();
%!    mkdir (folders{k});
%!    writeAtomic (fullfile (folders{k}, 'measured.csv'), varargin{k});
%!  end
%!  raw = struct ('folder', folders{end}, 'Input', struct ('model', 'Toy'));
%!  if reference
%!    raw.Input.reference = folders{1};
%!  end
%!  [list, p] = readConditions (raw, {'Toy'});
%!  reasons = arrayfun (@(q) strrep (q.id, 'DEcalioc:checkCase:', ''), ...
%!                      p(:)', 'UniformOutput', false);
%!endfunction
%!test
%! % the values of the earlier case are the reference
%! tables = {"name,value\na,1\n", "name,value\na,2\n"};
%! assert ([read(false, tables{2}).value], 2);
%! [list, reasons] = read (true, tables{:});
%! assert (isempty (reasons));
%! assert ({list.condition, list.value}, {'reference', 'now', 1, 2});
%! tables = {"name,value,session\na,1,mon\na,2,\n", "name,value,session\na,2,mon\n"};
%! assert ({read(true, tables{:}).session}, {'mon (reference)', '', 'mon'});
%!test
%! table = @(varargin) ["name,value,condition\n", ...
%!                      sprintf("a,1,%s\n", varargin{:})];
%! reasonsOf = @(varargin) nthargout (2, @read, varargin{:});
%! assert (isempty (reasonsOf (false, table ('reference', 'moist'))));
%! name = ['Lot 2 (5 % na', char([195, 159]), ')'];
%! assert (isempty (reasonsOf (false, table ('reference', name))));
%! assert (reasonsOf (false, table ('reference', 'Reference', 'wet')), ...
%!         {'measuredCondition'});
%! for bad = {{'reference', 'next'}, {'reference', 'a/b'}}
%!   assert (reasonsOf (false, table (bad{1}{:})), {'measuredCondition'});
%! end
%! for bad = {{'reference', 'reference'}, {'moist', 'wet'}, {'reference', ''}}
%!   assert (reasonsOf (false, table (bad{1}{:})), {'measuredCondition'});
%! end
%! tables = {"name,value\na,1\n", table('reference', 'wet')};
%! assert (reasonsOf (true, tables{:}), {'measuredCondition'});
%!test
%! % each fault names the table in which it is
%! folder = tempname ();
%! mkdir (fullfile (folder, 'gap', 'next'));
%! raw = struct ('folder', folder, 'Input', struct (), 'further', {{'B'}});
%! own = fullfile (folder, 'measured.csv');
%! test = fullfile (folder, 'gap', 'next', 'B.csv');
%! first = @(raw) nthargout (2, @readConditions, raw, {'A', 'B'})(1).message;
%! starts = @(raw, words) strncmp (first (raw), words, numel (words));
%! writeAtomic (own, "name,value\na,1\n");
%! for bad = {"name,value\na,1x\n", 'gap/next/B.csv, line 2, value: '; ...
%!            "name,vale\na,1\n", 'gap/next/B.csv: '; "", 'gap/next/B.csv: '}'
%!   writeAtomic (test, bad{1});
%!   assert (starts (raw, bad{2}), first (raw));
%! end
%! writeAtomic (test, "name,value\na,1\n");
%! before = emptyFolder ();
%! writeAtomic (fullfile (before, 'measured.csv'), "name,value\na,1x\n");
%! raw.Input.reference = folder;
%! assert (starts (raw, 'Input.reference in loadInput.m: expected the folder of another'), ...
%!         first (raw));
%! raw.Input.reference = before;
%! assert (starts (raw, fullfile (before, 'measured.csv, line 2, value: ')));

% SPDX-License-Identifier: GPL-3.0-only
