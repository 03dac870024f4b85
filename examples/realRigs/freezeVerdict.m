% FREEZEVERDICT  Writes verdict.json of a rig from gap/ of its case.
%
% CALL: octave-cli ../freezeVerdict.m PART   (in the folder of the rig)
%
%   PART  name of the powder or set and of its case in the folder of the rig; ''
%         where the rig has one and is the case
%
% One entry a series: rig, powder or set (the first column of engineer.csv), series,
% changed, p, class, named, cause, verdict (named, class, none of the listed, nothing,
% undecided, cannot tell), probability (of each candidate), decides (readings), strength
% (text), engineer (of engineer.csv, columns series, engineer: what one would say without
% the toolbox, written before the verdict was seen), says (the first words of the page:
% what has changed, and the verdict). Entries of other parts stay. Causes that the page
% does not name, as too few numbers or too many kinds are left, are no class here.
%
% See also: diagnoseGap

1;

function one = entryOf (gap, rig, part, engineer)
  which = gap.which;
  series = str2double (regexp (gap.reference.condition, '\d+$', 'match', 'once'));
  kinds = {'named', 'named'; 'group', 'class'; 'no gap', 'nothing'; ...
           'none of the listed', 'none of the listed'; ...
           'undecided', 'undecided'; 'surrogate', 'cannot tell'};
  at = find (strcmp (which.verdict, kinds(:, 1)), 1);
  isSilent = any (strcmp (gap.cause.code, {'oneNumber', 'fewNumbers', 'manyKinds'}));
  one = struct ('rig', rig, part.kind, part.name, 'series', series, ...
                'changed', ~strcmp (which.verdict, 'no gap'), 'p', which.p, ...
                'class', {listOf(which.class)}, 'named', '', 'cause', '', ...
                'verdict', kinds{at, 2}, 'probability', which.posterior, ...
                'decides', strjoin (listOf (which.decides), ', '), ...
                'strength', '', 'engineer', engineer(part.name, series), ...
                'says', strtrim ([gap.verdict.change, ' ', gap.verdict.cause.word]));
  if strcmp (gap.cause.kind, 'cannot tell')
    one.verdict = 'cannot tell';
  elseif isSilent
    [one.verdict, one.class] = deal ('undecided', {});
    return
  end
  effects = listOf (which.effects);
  if strcmp (which.verdict, 'group')
    one.class = union (one.class, effects, 'stable');
  elseif strcmp (which.verdict, 'named')
    one.named = strjoin (effects, ' and ');
  end
  if ~isempty (which.cause)
    [p, best] = max ([which.cause.probability]);
    one.cause = which.cause(best).name(1:end * (p > 0.5));
  end
  texts = cellfun (@(e) which.strength.(e).text, effects, 'UniformOutput', false);
  one.strength = strjoin (texts, '; ');
end

function list = listOf (value)
  list = cellstr (value)(:)';
  list = list(~cellfun (@isempty, list));
end

root = fullfile (fileparts (mfilename ('fullpath')), '..', '..');
addpath (fullfile (root, 'infrastructure'));
startToolbox (make_absolute_filename (root), pwd ());
[~, rig] = fileparts (pwd ());
[head, cells] = readCsvTable ('engineer.csv');
part = struct ('kind', head{1}, 'name', [argv(){:}]);
isOf = @(name, text) strcmp (cells(:, strcmp (head, name)), text);
words = cells(:, strcmp (head, 'engineer'));
said = @(name, series) [words{isOf(part.kind, name) & ...
                              isOf('series', sprintf ('%d', series))}];
% of several conditions each has a folder, and one of them stands above, too
files = glob (fullfile (part.name, 'gap', '*', 'gap.json'))';
if isempty (files)
  files = {fullfile(part.name, 'gap', 'gap.json')};
end
list = {};
if isfile ('verdict.json')
  old = jsondecode (fileread ('verdict.json'), 'makeValidName', false);
  if ~iscell (old)
    old = num2cell (old);
  end
  isOwn = cellfun (@(one) strcmp (one.(part.kind), part.name), old);
  list = old(~isOwn)(:)';
end
for file = files
  list{end + 1} = entryOf (jsondecode (fileread (file{1})), rig, part, said);
end
writeAtomic ('verdict.json', [jsonencode(list), "\n"]);

% SPDX-License-Identifier: GPL-3.0-only
