% BATCHEXECUTOR  What all queues have in common, for describeExecutor.
%
% CALL: WHAT = batchExecutor (NAME, TITLE, OWN)
%
%   NAME   name of the executor (text)
%   TITLE  name of the queue as users write it (text)
%   OWN    see batchCheck
%   WHAT   scalar struct, see describeExecutor, and name, title, options
%          (handle OPT = options (CASE.options), see batchOptions)
%
% The queue adds program, and its commands, see batchExecute.
%
% See also: slurmExecutor

function what = batchExecutor (name, title, own)
  what.name = name;
  what.title = title;
  what.isHere = false;
  what.check = @(given) batchCheck (given, name, own);
  what.options = @(options) optionsOf (options, name, own.words);
  what.sets = @(options) optionsOf (options, name, own.words).sets;
end

function opt = optionsOf (options, name, words)
  given = [];
  if isfield (options, name)
    given = options.(name);
  end
  opt = batchOptions (given, words);
end

%!test
%! own = struct ('words', {{'group'}});
%! what = batchExecutor ('q', 'Queue', own);
%! assert (what.options (struct ('q', struct ('group', 'a'))).group, 'a');
%! assert (what.options (struct ()).group, '');
