% CHECKFOLDERNAME  Tells whether a text is safe as the name of one folder.
%
% CALL: YES = checkFolderName (NAME)
%
%   NAME  1 x n char
%   YES   true where it holds only letters, digits, _ - + . and characters
%         beyond ASCII, starts with neither dot nor minus, and is at most 100
%         bytes long: it cannot leave its folder or break a shell line
%
% See also: checkInputFields, checkShow

function yes = checkFolderName (name)
  plain = ['A':'Z', 'a':'z', '0':'9', '_-+.'];
  yes = numel (name) <= 100 && all (ismember (name, plain) | name > 127) && ...
        ~any (name(1) == '.-') && isempty (strfind (name, '..'));
end

%!assert (checkFolderName ('Lift100'))
%!assert (checkFolderName ('a-b_c+1.5'))
%!assert (! checkFolderName ('../x'))
%!assert (! checkFolderName ('a b'))
%!assert (! checkFolderName ('-a'))
%!assert (! checkFolderName ('a;b'))
%!assert (checkFolderName (char ([66, 195, 182])))
