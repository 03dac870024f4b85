% FREEZEVERDICT  Writes verdict.json of a rig from gap/ of its case.
%
% CALL: octave-cli ../freezeVerdict.m POWDER   (in the folder of the rig)
%
%   POWDER  name of the powder and of its case in the folder of the rig; '' where
%           the rig has one powder and is the case
%
% One entry a series: rig, powder, series, changed, p, class, named, cause,
% verdict (named, class, none of the listed, nothing, undecided, cannot tell),
% probability (of each candidate), decides (readings), strength (text), engineer
% (of engineer.csv, columns powder, series, engineer: what one would say without
% the toolbox, written before the verdict was seen). Entries of other powders stay.
%
% See also: diagnoseGap

1;

function one = entryOf (gap, rig, powder, engineer)
  which = gap.which;
  series = str2double (regexp (gap.reference.condition, '\d+$', 'match', 'once'));
  kinds = {'named', 'named'; 'group', 'class'; 'no gap', 'nothing'; ...
           'none of the listed', 'none of the listed'; ...
           'undecided', 'undecided'; 'surrogate', 'cannot tell'};
  at = find (strcmp (which.verdict, kinds(:, 1)), 1);
  one = struct ('rig', rig, 'powder', powder, 'series', series, ...
                'changed', ~strcmp (which.verdict, 'no gap'), 'p', which.p, ...
                'class', {listOf(which.class)}, 'named', '', 'cause', '', ...
                'verdict', kinds{at, 2}, 'probability', which.posterior, ...
                'decides', strjoin (listOf (which.decides), ', '), ...
                'strength', '', 'engineer', engineer(powder, series));
  if strcmp (gap.cause.kind, 'cannot tell')
    one.verdict = 'cannot tell';
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
powder = [argv(){:}];
[~, rig] = fileparts (pwd ());
[head, cells] = readCsvTable ('engineer.csv');
isOf = @(name, text) strcmp (cells(:, strcmp (head, name)), text);
words = cells(:, strcmp (head, 'engineer'));
said = @(powder, series) [words{isOf('powder', powder) & ...
                                isOf('series', sprintf ('%d', series))}];
files = [{fullfile(powder, 'gap', 'gap.json')}, ...
         glob(fullfile (powder, 'gap', '*', 'gap.json'))'];
list = {};
if isfile ('verdict.json')
  old = jsondecode (fileread ('verdict.json'), 'makeValidName', false);
  list = num2cell (old(~strcmp ({old.powder}, powder)))(:)';
end
for file = files
  list{end + 1} = entryOf (jsondecode (fileread (file{1})), rig, powder, said);
end
writeAtomic ('verdict.json', [jsonencode(list), "\n"]);
