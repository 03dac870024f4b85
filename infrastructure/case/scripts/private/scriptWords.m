% SCRIPTWORDS  Words of a script that may name a file, its variables filled in.
%
% CALL: [WORDS, BASES, FILLED] = scriptWords (TEXT, SCRIPT, FOLDER, PLACE)
%
%   TEXT    of the script;  SCRIPT  its path (texts)
%   FOLDER  model folder, PLACE  run folder, see namedFiles
%   WORDS   1 x n cell; a $ is left where a variable is not known. What the
%           script writes is not among them
%   BASES   1 x b cell of folders that a relative name may be seen from: the
%           model folder, PLACE and those that the script changes to
%   FILLED  TEXT without remarks, its variables filled in

function [words, bases, filled] = scriptWords (text, script, folder, place)
  here = {'\$\{?PWD\}?(?!\w)', place; '\$\(pwd\)', place; '`pwd`', place; ...
          '\$\(dirname "?\$\{?(0|BASH_SOURCE(\[0\])?)\}?"?\)', ...
          fileparts(script)};
  if strncmp (script, folder, numel (folder))
    here{4, 2} = place;                         % it is called in the run folder
  end
  text = regexprep (text, '^[ \t]*#[^\n]*|(?<=\s)#[^\n]*', '', 'lineanchors');
  for k = 1:4
    text = regexprep (text, here{k, 1}, strrep (here{k, 2}, '$', '\$'));
  end
  filled = filledIn (text);
  text = regexprep (filled, ...
                    {'\d?>{1,2}[ \t]*[^\s;&|]+', ...
                     '^[ \t]*(rm|mkdir|touch)[ \t][^\n;&|]*', ...
                     '\<tee[ \t][^\n;&|]*', ...
                     ['^([ \t]*(cp|mv|ln|rsync)[ \t][^\n;&|]*)[ \t]+', ...
                      '[^\s;&|]+[ \t]*$']}, ...
                    {' ', '', '', '$1'}, 'lineanchors');
  words = unique (regexp (text, '[\w./+~${}@%-]+', 'match'));
  words = regexprep (words, '^~(?=/)', getenv ('HOME'));
  words = words(~cellfun (@isempty, regexp (words, '[A-Za-z]', 'once')));
  moves = regexp (text, '(?:^|[;&|(]|then|do)\s*(?:cd|pushd)\s+(?:--\s+)?["'']?([^\s"'';&|)]+)', ...
                  'tokens', 'lineanchors');
  moves = [cell(1, 0), moves{:}];
  isRelative = ~strncmp (moves, '/', 1);
  inModel = strcat (folder, '/', moves(isRelative));
  moves(isRelative) = strcat (place, '/', moves(isRelative));
  bases = [{folder, place}, moves, inModel];
end

% Shell variables that are set to a plain text, or that the environment alone sets.
function text = filledIn (text)
  text = regexprep (text, '\$\{(\w+):?-([^}$]*)\}', '$2');
  set_ = ['^\s*(?:(?:export|readonly|local|declare(?:\s+-\w+)*)\s+)?(\w+)=' ...
          '["'']?([\w./+~-]+)["'']?\s*(?:$|;)'];
  pairs = regexp (text, set_, 'tokens', 'lineanchors');
  for pair = fliplr (pairs)
    text = replaced (text, pair{1}{:});
  end
  names = regexp (text, '\$\{?([A-Za-z_]\w*)', 'tokens');
  for name = unique ([cell(1, 0), names{:}])
    isSet = ~isempty (regexp (text, ['(?<![\w$])', name{1}, '='], 'once'));
    if ~isSet && ~isempty (getenv (name{1}))
      text = replaced (text, name{1}, getenv (name{1}));
    end
  end
end

function text = replaced (text, name, value)
  text = regexprep (text, ['\$(\{', name, '\}|', name, '(?!\w))'], ...
                    strrep (value, '$', '\$'));
end

%!test
%! [words, bases] = scriptWords (["A=/x/y\n$A/z $B_NOT/c ${A}b > out\n", ...
%!                                "cd ../lib && ./run # no/more\n"], ...
%!                               '/m/runscript', '/m', '/s/0001');
%! for word = {'/x/y/z', '$B_NOT/c', '/x/yb', './run', '../lib'}
%!   assert (any (strcmp (words, word{1})), word{1});
%! end
%! assert (~any (ismember ({'out', 'no/more'}, words)));
%! assert (bases, {'/m', '/s/0001', '/s/0001/../lib', '/m/../lib'});

% SPDX-License-Identifier: GPL-3.0-only
