% SENTENCE  The sentence that stands for a code, with its numbers filled in.
%
% CALL: [TEXT, PARTS] = sentence (CODE [, VALUES [, ISCHANGE]])
%
%   CODE      code of words.txt, such as 'ending.outside' (text)
%   VALUES    scalar struct with what the sentence names (default: nothing); a cell
%             of texts is its field names
%   ISCHANGE  logical (false): said of a change from a reference, not of what
%             the model lacks; such words stand there behind CODE/changed, where
%             they differ
%   TEXT      text, without HTML
%   PARTS     1 x n struct array text, isCode: TEXT in parts, of which those that stand in
%             `such marks` in words.txt are commands, files and fields
%
% words.txt is the only place of what is said of a code, so that nobody needs to
% compare a sentence and every sentence may be reworded. In it {name} stands for
% a field of VALUES (texts of a cell are joined by commas, or by WORD where it
% reads {name&WORD}), {name|run|runs} for a count with its noun.
%
% Errors: DEcalioc:sentence:unknownName for a code that is not in words.txt, or
% a name that is not in VALUES

function [text, parts] = sentence (code, values, isChange)
  if nargin < 2
    values = struct ();
  elseif iscell (values)
    values = struct ('names', {values});
  end
  text = '';
  if nargin > 2 && isChange
    text = lookUp ([code, '/changed']);
  end
  if isempty (text)
    text = lookUp (code);
  end
  if isempty (text)
    error ('DEcalioc:sentence:unknownName', ...
           'sentence: CODE must stand in words.txt, got ''%s''.', code);
  end
  pieces = strsplit (text, '`');
  texts = cellfun (@(piece) fillAll (piece, values, code), pieces, ...
                   'UniformOutput', false);
  parts = struct ('text', texts, 'isCode', num2cell (mod (1:numel (texts), 2) == 0));
  parts = parts(~cellfun (@isempty, texts));
  text = [texts{:}];
end

function text = lookUp (code)
  file = fullfile (fileparts (mfilename ('fullpath')), 'words.txt');
  found = regexp (fileread (file), ...
                  ['^', regexptranslate('escape', code), ': *([^\n]*)'], ...
                  'tokens', 'once', 'lineanchors');
  text = [found{:}, ''];
end

function text = fillAll (text, values, code)
  [places, fixed] = regexp (text, '\{([^{}]*)\}', 'tokens', 'split');
  filled = cellfun (@(place) fill (place{1}, values, code), places, ...
                    'UniformOutput', false);
  pieces = [fixed; [filled, {''}]];
  text = [pieces{:}];
end

function text = fill (place, values, code)
  words = strsplit (place, '|');
  [name, joint] = strtok (words{1}, '&');
  if ~isfield (values, name)
    error ('DEcalioc:sentence:unknownName', ...
           'sentence: VALUES must have the field %s of ''%s'', got: %s.', ...
           name, code, strjoin (fieldnames (values), ', '));
  end
  value = values.(name);
  if numel (words) == 3
    text = countText (value, words{2:3});
  elseif iscell (value)
    text = strjoin (value(:)', [joint(2:end), repmat(', ', 1, isempty (joint))]);
  elseif ischar (value)
    text = value;
  else
    text = sprintf (merge (value == round (value), '%d', '%.4g'), value);
  end
end

%!test
%! values = struct ('probability', 97, 'runs', 1, 'limited', 'L');
%! assert (! isempty (strfind (sentence ('ending.unsure', values), '1 run')));
%! values.runs = 3;
%! text = sentence ('ending.unsure', values);
%! assert (! isempty (strfind (text, '97')) && isempty (strfind (text, '{')));
%!test
%! % commands, files and fields are parts of their own, filled as the rest is
%! [text, parts] = sentence ('action.raise', struct ('field', {{'Input.x'}}));
%! assert (text, 'Raise Input.x and start decalioc run again.');
%! assert ([parts.text], text);
%! assert ({parts([parts.isCode]).text}, {'Input.x', 'decalioc run'});
%!test
%! % words of a change only where they differ
%! plain = sentence ('ending.allFailed');
%! assert (sentence ('ending.allFailed', struct (), true), plain);
%!test
%! % each code once, each line a code with a sentence; all codes of the
%! % functions are there
%! file = fullfile (fileparts (which ('sentence')), 'words.txt');
%! lines = strsplit (strtrim (fileread (file)), "\n");
%! lines = lines(! strncmp (lines, '#', 1) & ! cellfun (@isempty, lines));
%! codes = regexp (lines, '^([a-z][\w.-]*(?:/changed)?): \S', 'tokens', 'once');
%! assert (! any (cellfun (@isempty, codes)));
%! codes = [codes{:}];
%! assert (numel (unique (codes)), numel (codes));
%!error id=DEcalioc:sentence:unknownName sentence ('ending.none')
%!error id=DEcalioc:sentence:unknownName sentence ('ending.conflict')

% SPDX-License-Identifier: GPL-3.0-only
